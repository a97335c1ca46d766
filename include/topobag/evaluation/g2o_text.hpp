// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/error.hpp>
#include <topobag/evaluation/detail/pose_text.hpp>
#include <topobag/evaluation/number_text.hpp>
#include <topobag/types/detail/cholesky.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/pose_with_covariance.hpp>
#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {

/// What the reader of a g2o file takes the rotation in an edge's information to be.
enum class G2oRotation {
  half_angles,      ///< a unit quaternion's x, y, z: g2o itself
  rotation_vector,  ///< rad: GTSAM's `readG2o`
};

/// Writes `VERTEX_SE3:QUAT id tx ty tz qx qy qz qw`, whatever the locale. Throws InvalidValue for a
/// pose that is no rigid motion.
inline void write_g2o_vertex(std::ostream& stream, KeyframeId id,
                             const Eigen::Isometry3d& T_world_camera) {
  require_rigid(T_world_camera, "the vertex's pose");
  stream << "VERTEX_SE3:QUAT " << std::to_string(value(id)) << ' ';
  detail::write_pose(stream, T_world_camera);
  stream << '\n';
}

/// The information that g2o's `EdgeSE3` weighs its error by: translation, then rotation, right of
/// the pose. Throws InvalidValue for a pose that is no rigid motion, and for a covariance that leaves
/// some error out: such a factor would be a constraint.
/// @param T_from_to  a `PoseWithCovariance`
template <typename Pose>
Eigen::Matrix<double, 6, 6> g2o_information(const Pose& T_from_to,
                                            G2oRotation rotation = G2oRotation::half_angles) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  require_rigid(T_from_to.T, "the edge's pose");
  const Matrix6 covariance = T_from_to.template as<G2oPose>().covariance;
  Matrix6 information = detail::inverse_covariance(covariance);
  if (!information.allFinite()) {
    throw InvalidValue(
        "the covariance of an edge's pose has no inverse: a factor is uncertain in all six "
        "directions");
  }
  if (rotation == G2oRotation::half_angles) {
    information.topRightCorner<3, 3>() *= 2.0;
    information.bottomLeftCorner<3, 3>() *= 2.0;
    information.bottomRightCorner<3, 3>() *= 4.0;
  }
  return information;
}

/// Writes `EDGE_SE3:QUAT from to tx ty tz qx qy qz qw` and the upper triangle of the information,
/// row by row, whatever the locale. Throws as `g2o_information`.
/// @param T_from_to  a `PoseWithCovariance`: of a loop, from the candidate to the query
template <typename Pose>
void write_g2o_edge(std::ostream& stream, KeyframeId from, KeyframeId to, const Pose& T_from_to,
                    G2oRotation rotation = G2oRotation::half_angles) {
  const auto information = g2o_information(T_from_to, rotation);
  stream << "EDGE_SE3:QUAT " << std::to_string(value(from)) << ' ' << std::to_string(value(to))
         << ' ';
  detail::write_pose(stream, T_from_to.T);
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = row; column < 6; ++column) {
      write_number(stream.put(' '), information(row, column));
    }
  }
  stream << '\n';
}

}  // namespace v0
}  // namespace topobag
