// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: specialise topobag::detection_traits for your detection type
// MISFIT 2: topobag: specialise topobag::detection_traits for your detection type
// MISFIT 3: topobag: specialise topobag::detection_traits for your detection type
// MISFIT 4: topobag: without a depth source, topobag::detection_traits needs depth(const T&)
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/range_detections.hpp>

using namespace topobag;

struct Box {
  float left, top, right, bottom;
  int name;
};

#if MISFIT != 1 && MISFIT != 2
template <>
struct topobag::detection_traits<Box> {
  static BoundingBox box(const Box& b) { return {b.left, b.top, b.right, b.bottom}; }
#if MISFIT == 3
  static int label(const Box& b) { return b.name; }
#else
  static ClassId label(const Box& b) { return ClassId{b.name}; }
#endif
  static double confidence(const Box&) { return 1.0; }
#if MISFIT != 4
  static std::optional<double> depth(const Box&) { return 2.0; }
#endif
};
#endif

int main() {
  const auto wall = [](const Eigen::Vector2d&) -> std::optional<double> { return 2.0; };
  const std::vector<Box> boxes;
  const PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, 640, 480};
  const ClassCatalog catalog = ClassCatalog::coco80();
#if MISFIT == 2
  return static_cast<int>(range_detections(boxes, wall, camera).size());
#elif MISFIT == 4
  return static_cast<int>(lift_detections(boxes, camera, catalog).nodes.size());
#else
  return static_cast<int>(lift_detections(boxes, wall, camera, catalog).nodes.size() +
                          lift_detections(boxes, camera, catalog).nodes.size() +
                          range_detections(boxes, wall, camera).size());
#endif
}
