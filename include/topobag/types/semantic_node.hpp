// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>

#include <Eigen/Core>

#include <topobag/types/appearance.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/label_weights.hpp>

namespace topobag {
inline namespace v0 {

/// One object seen from a camera: the paper's o_i = (u, v, z, c) of eq. 1, with its place in space.
///
/// Frame: the camera of the graph's key frame, x right, y down, z forward, metres.
template <typename Scalar_ = double>
struct SemanticNode {
  static_assert(std::is_floating_point_v<Scalar_>,
                "topobag: the scalar of nodes and graphs is a floating-point type.");

  using Scalar = Scalar_;
  using Vector2 = Eigen::Matrix<Scalar, 2, 1>;
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;

  ClassId label{};                  ///< class, c of eq. 1
  LabelWeights label_weights{};     ///< what it may be, `label` among the best; none: that alone
  std::optional<Vector2> pixel;     ///< box centre (u, v), px; absent behind the camera
  Scalar z = Scalar(0);             ///< depth, m; 0 = unknown
  std::optional<Vector3> position;  ///< (X, Y, Z) in the camera frame, m; absent without depth
  Matrix3 covariance =
      Matrix3::Zero();             ///< of `position`, m², positive definite; zero = not modelled
  Vector2 size = Vector2::Zero();  ///< extent parallel to the image, m; 0 = unknown
  Scalar confidence = Scalar(1);   ///< detector's score in [0, 1]
  Scalar existence = Scalar(1);  ///< share of the frames that should have shown it and did, (0, 1]
  Appearance appearance{};       ///< what it looks like; unknown by default
};

}  // namespace v0
}  // namespace topobag
