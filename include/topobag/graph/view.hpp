// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/bounding_box.hpp>

namespace topobag {
inline namespace v0 {

/// A box that hides what lies behind it.
struct Occluder {
  BoundingBox box;  ///< px
  double z = 0.0;   ///< m; 0 = unknown, then it may hide anything
};

/// One camera that looked for a graph's nodes: with it, an object that is missing can be told from
/// one that nobody could see.
template <typename Scalar_ = double>
struct View {
  using Scalar = Scalar_;
  using Pose = Eigen::Transform<Scalar, 3, Eigen::Isometry>;

  Pose T_graph_camera = Pose::Identity();  ///< from this camera's frame to the graph's
  PinholeCamera<Scalar> camera;            ///< with its image size
  std::vector<Occluder> occluders;         ///< everything detected, dynamic objects too

  /// Whether an object at `point` (graph frame, m) should have shown in this image: its centre at
  /// least `margin` px inside, nearer than `max_depth` m and behind no occluder. False when the
  /// image size is unknown.
  bool should_show(const Eigen::Matrix<Scalar, 3, 1>& point, Scalar margin,
                   Scalar max_depth) const {
    const Eigen::Matrix<Scalar, 3, 1> in_camera = T_graph_camera.inverse() * point;
    if (in_camera.z() > max_depth) return false;
    const auto pixel = camera.project(in_camera);
    if (!pixel || !camera.in_image(*pixel, margin)) return false;
    for (const Occluder& occluder : occluders) {
      const bool nearer =
          !(occluder.z > 0.0) || occluder.z < 0.85 * static_cast<double>(in_camera.z());
      if (nearer && occluder.box.contains(pixel->template cast<double>())) return false;
    }
    return true;
  }
};

}  // namespace v0
}  // namespace topobag
