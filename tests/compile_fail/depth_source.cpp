// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: a depth source is callable as depth(Eigen::Vector2d pixel)
// MISFIT 2: topobag: a depth source is callable as depth(Eigen::Vector2d pixel)
// MISFIT 3: topobag: a depth source is callable as depth(Eigen::Vector2d pixel)
// MISFIT 4: topobag: a depth source is callable as depth(Eigen::Vector2d pixel)
// MISFIT 5: topobag: a source of disparities is callable as disparity(Eigen::Vector2d pixel)
#include <topobag/sensing/depth_grid.hpp>
#include <topobag/sensing/disparity_depth.hpp>
#include <topobag/sensing/dynamic_feature_mask.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/range_detections.hpp>

using namespace topobag;

struct Wall {
#if MISFIT
  float operator()(int, int) const { return 2.0F; }
#else
  std::optional<double> operator()(const Eigen::Vector2d&) const { return 2.0; }
#endif
};

int main() {
  const PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, 640, 480};
  const ClassCatalog catalog = ClassCatalog::coco80();
  const std::vector<Detection> detections;
#if MISFIT <= 1
  const auto lifted = lift_detections(detections, Wall{}, camera, catalog);
#endif
#if MISFIT == 0 || MISFIT == 2
  const auto ranged = range_detections(detections, Wall{}, camera);
#endif
#if MISFIT == 0 || MISFIT == 3
  const DepthGrid grid(Wall{}, 640, 480);
#endif
#if MISFIT == 0 || MISFIT == 4
  const auto masked = DynamicFeatureMask({}, catalog).masked({}, Wall{});
#endif
#if MISFIT == 0 || MISFIT == 5
  const DisparityDepth<Wall> stereo({}, 500.0, 0.1);
#endif
}
