// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: a depth sampling policy is callable as sampling(depth source, BoundingBox)
// MISFIT 2: topobag: a depth sampling policy is callable as sampling(depth source, BoundingBox)
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/range_detections.hpp>

using namespace topobag;

struct Sampling {
#if MISFIT
  double operator()(const BoundingBox&) const { return 2.0; }
#else
  template <typename Depth>
  double operator()(const Depth& depth, const BoundingBox& box) const {
    return *depth(box.center());
  }
#endif
};

int main() {
  const auto wall = [](const Eigen::Vector2d&) -> std::optional<double> { return 2.0; };
  const PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, 640, 480};
  const std::vector<Detection> detections;
#if MISFIT <= 1
  const auto lifted =
      lift_detections(detections, wall, camera, ClassCatalog::coco80(), {}, Sampling{});
#endif
#if MISFIT == 0 || MISFIT == 2
  const auto ranged = range_detections(detections, wall, camera, Sampling{});
#endif
}
