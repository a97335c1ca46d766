// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/error.hpp>
#include <topobag/sensing/depth_grid.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/bounding_box.hpp>
#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/types/rigid_motion.hpp>

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
  using Depth = DepthGrid;

  Pose T_graph_camera = Pose::Identity();  ///< from this camera's frame to the graph's
  PinholeCamera<Scalar> camera;            ///< with its image size
  std::vector<Occluder> occluders;         ///< everything detected, dynamic objects too
  std::optional<Depth> depth;              ///< measured by this camera, of its image's size

  /// Throws InvalidValue for a pose that is no rigid motion, a number that is not finite, and a
  /// depth of another size than the camera's image. O(occluders).
  void validate() const {
    require_rigid(T_graph_camera, "a view's pose");
    bool finite = true;
    for (const Scalar x : {camera.fx, camera.fy, camera.cx, camera.cy}) {
      finite = finite && std::isfinite(x);
    }
    for (const Occluder& o : occluders) {
      for (const double x : {o.box.x1, o.box.y1, o.box.x2, o.box.y2, o.z}) {
        finite = finite && std::isfinite(x);
      }
    }
    if (!finite) {
      throw InvalidValue("a view's camera or occluder holds a number that is not finite; 0 is the "
                         "depth that is unknown");
    }
    if (depth && (depth->width() != camera.width || depth->height() != camera.height)) {
      throw InvalidValue("a view's depth is of another size than its camera's image, or that is "
                         "not known");
    }
  }

  /// Where a point (graph frame, m) falls into this image when it is at least `margin` px inside
  /// and nearer than `max_depth` m, and its distance along the optical axis, m. Nothing when the
  /// image size is unknown.
  std::optional<std::pair<Eigen::Vector2d, double>> in_field(
      const Eigen::Matrix<Scalar, 3, 1>& point, Scalar margin, Scalar max_depth) const {
    const Eigen::Matrix<Scalar, 3, 1> in_camera =
        T_graph_camera.linear().transpose() * (point - T_graph_camera.translation());
    if (in_camera.z() > max_depth) return std::nullopt;
    const auto pixel = camera.project(in_camera);
    if (!pixel || !camera.in_image(*pixel, margin)) return std::nullopt;
    return std::make_pair(pixel->template cast<double>().eval(),
                          static_cast<double>(in_camera.z()));
  }

  /// Whether an object at `point` (graph frame, m) should have shown in this image: in its field
  /// and behind no occluder.
  bool should_show(const Eigen::Matrix<Scalar, 3, 1>& point, Scalar margin,
                   Scalar max_depth) const {
    const auto seen = in_field(point, margin, max_depth);
    if (!seen) return false;
    const auto& [pixel, z] = *seen;
    for (const Occluder& occluder : occluders) {
      const bool nearer = !(occluder.z > 0.0) || occluder.z < 0.85 * z;
      if (nearer && occluder.box.contains(pixel)) return false;
    }
    return true;
  }

  /// Whether this camera looked through `point` (graph frame, m): in its field, and the depth
  /// measured there lies beyond it by more than `clearance` m. False where nothing was measured.
  bool sees_through(const Eigen::Matrix<Scalar, 3, 1>& point, Scalar margin, Scalar max_depth,
                    double clearance) const {
    const auto seen = depth ? in_field(point, margin, max_depth) : std::nullopt;
    if (!seen) return false;
    const std::optional<double> measured = (*depth)(seen->first);
    return measured && *measured > seen->second + clearance;
  }
};

}  // namespace v0
}  // namespace topobag
