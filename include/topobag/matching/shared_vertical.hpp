// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/detail/least_turn.hpp>

namespace topobag {
inline namespace v0 {

/// The vertical as two graphs know it. A pose between them is then free in yaw and translation
/// alone; how far it may tilt, the noise of both says.
struct SharedVertical {
  Eigen::Vector3d target_down;  ///< unit vector, target frame
  Eigen::Vector3d source_down;  ///< unit vector, source frame
  double variance = 0.0;        ///< of the tilt between them about each horizontal axis, rad²

  /// The small turn, in the target's frame, rad, that takes the source's vertical, moved by `R`, to
  /// the target's.
  template <typename Derived>
  Eigen::Vector3d tilt(const Eigen::MatrixBase<Derived>& R) const {
    return (R * source_down).cross(target_down);
  }

  /// The rotation that is level and turned by `yaw`, rad, about the upward vertical, measured from
  /// the one that turns least.
  template <typename Angle>
  Eigen::Matrix3d rotation(Angle yaw) const {
    return Eigen::AngleAxis<Angle>(yaw, -target_down).toRotationMatrix() * least_turn();
  }

  /// How far `R` turns about the vertical, rad, in [0, π].
  template <typename Derived>
  double yaw(const Eigen::MatrixBase<Derived>& R) const {
    // What a rotation does about an axis: its quaternion's part along the axis, and its real part.
    const Eigen::Quaterniond turn(Eigen::Matrix3d(R * least_turn().transpose()));
    const double half = std::atan2(std::abs(turn.vec().dot(target_down)), std::abs(turn.w()));
    return 2.0 * half;
  }

 private:
  template <typename Vector = Eigen::Vector3d>
  Eigen::Matrix3d least_turn() const {
    return detail::least_turn<Vector, Vector>(source_down, target_down);
  }
};

/// Nothing unless both graphs know which way is down.
template <typename Scalar>
std::optional<SharedVertical> shared_vertical(const TopologyGraph<Scalar>& target,
                                              const TopologyGraph<Scalar>& source) {
  const auto& there = target.gravity();
  const auto& here = source.gravity();
  if (!there || !here) return std::nullopt;
  const auto variance = [](const auto& gravity) {
    const auto deviation = static_cast<double>(gravity->deviation);
    return deviation * deviation;
  };
  return SharedVertical{there->down.template cast<double>(), here->down.template cast<double>(),
                        variance(there) + variance(here)};
}

}  // namespace v0
}  // namespace topobag
