// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <topobag/edges/insertion_error.hpp>
#include <topobag/error.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

// A projection takes the nodes and returns a callable `node -> std::optional<Eigen::Vector2d>`:
// where the node lies in the plane that a planar edge builder triangulates, empty if nowhere.
// A user's own projection is any callable of that shape.

/// The paper's plane (section 3.3.2): box centres (u, v), px. Nodes without a pixel have no place.
/// For single frames: it needs no depth, but two objects one behind the other become neighbours.
struct ImagePlane {
  template <typename Scalar>
  auto operator()(const std::vector<SemanticNode<Scalar>>&) const noexcept {
    return [](const SemanticNode<Scalar>& node) -> std::optional<Eigen::Vector2d> {
      if (!node.pixel) return std::nullopt;
      return node.pixel->template cast<double>();
    };
  }
};

namespace detail {

/// The place of a node's position in the plane spanned by the two rows of `axes`, m.
class PlaneProjection {
 public:
  explicit PlaneProjection(const Eigen::Matrix<double, 2, 3>& axes) : axes_(axes) {}

  template <typename Scalar>
  std::optional<Eigen::Vector2d> operator()(const SemanticNode<Scalar>& node) const {
    if (!node.position) return std::nullopt;
    const Eigen::Vector2d place = axes_ * node.position->template cast<double>();
    return Eigen::Vector2d(mitigate_underflow(place.x()), mitigate_underflow(place.y()));
  }

 private:
  Eigen::Matrix<double, 2, 3> axes_;
};

}  // namespace detail

/// The plane across gravity: a bird's-eye view, m. Nodes without a position have no place.
/// For objects that stand on one floor; the edges do not depend on how the camera is tilted.
class GroundPlane {
 public:
  /// `gravity`: a vector along gravity in the nodes' frame, of any length and either sense.
  /// Throws `InvalidValue` unless it is finite and not zero.
  explicit GroundPlane(const Eigen::Vector3d& gravity) : axes_(axes_across(gravity)) {}

  template <typename Scalar>
  auto operator()(const std::vector<SemanticNode<Scalar>>&) const {
    return detail::PlaneProjection(axes_);
  }

 private:
  static Eigen::Matrix<double, 2, 3> axes_across(const Eigen::Vector3d& gravity) {
    if (!gravity.allFinite() || gravity.isZero(0.0)) {
      throw InvalidValue("The gravity vector must be finite and not zero: give its direction.");
    }
    const Eigen::Vector3d down = (gravity / gravity.cwiseAbs().maxCoeff()).normalized();
    const Eigen::Vector3d side = down.unitOrthogonal();
    Eigen::Matrix<double, 2, 3> axes;
    axes.row(0) = side;
    axes.row(1) = down.cross(side);
    return axes;
  }

  Eigen::Matrix<double, 2, 3> axes_;  ///< rows: two unit vectors across gravity
};

/// The plane in which the positions spread most (their two largest principal axes), m. Nodes
/// without a position have no place. For objects on one wall, shelf or table of unknown pose.
/// The axes are rounded sums over the nodes: another order of the nodes may move a place by some
/// 1e-15 of the layout's size, and so flip an edge between four nodes on one circle.
/// Throws `InsertionError` with the node's index on a position that cannot be triangulated.
struct BestFitPlane {
  template <typename Scalar>
  auto operator()(const std::vector<SemanticNode<Scalar>>& nodes) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].position) continue;
      validate_position(*nodes[i].position, i);
      sum += nodes[i].position->template cast<double>();
      count += 1.0;
    }
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& node : nodes) {
      if (!node.position) continue;
      const Eigen::Vector3d offset = node.position->template cast<double>() - sum / count;
      scatter += offset * offset.transpose();
    }
    // Eigenvalues ascend, so the plane's normal is the first axis.
    const Eigen::Matrix3d axes =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors();
    return detail::PlaneProjection(axes.rightCols<2>().transpose());
  }
};

namespace detail {

template <typename Projection, typename Scalar, typename = void>
struct is_projection : std::false_type {};
template <typename Projection, typename Scalar>
struct is_projection<Projection, Scalar,
                     std::enable_if_t<std::is_invocable_v<
                         const Projection&, const std::vector<SemanticNode<Scalar>>&>>>
    : std::is_invocable_r<
          std::optional<Eigen::Vector2d>,
          const std::invoke_result_t<const Projection&, const std::vector<SemanticNode<Scalar>>&>&,
          const SemanticNode<Scalar>&> {};

}  // namespace detail

/// Whether `Projection` tells a planar edge builder where nodes of `Scalar` lie (C++20: `concept
/// Projection`).
template <typename Projection, typename Scalar>
inline constexpr bool is_projection_v = detail::is_projection<Projection, Scalar>::value;

}  // namespace v0
}  // namespace topobag
