// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include <Eigen/Geometry>

#include <topobag/types/rigid_motion.hpp>

namespace topobag {
inline namespace v0 {

/// A 4 × 4 pose row by row, in single precision: what crosses the border to a host that was built
/// with other vector instructions, where Eigen types must not. `cv::Mat(4, 4, CV_32F, p.data())`.
using PlainPose = std::array<float, 16>;

/// The pose row by row.
inline PlainPose plain_pose(const Eigen::Isometry3d& T) {
  PlainPose plain{};
  Eigen::Map<Eigen::Matrix<float, 4, 4, Eigen::RowMajor>>(plain.data()) = T.matrix().cast<float>();
  return plain;
}

namespace detail {

template <typename Pose, typename = void>
struct has_matrix : std::false_type {};
template <typename Pose>
struct has_matrix<Pose, std::void_t<decltype(std::declval<const Pose&>().matrix())>>
    : std::true_type {};

template <typename Pose, typename = void>
struct has_float_at : std::false_type {};
template <typename Pose>
struct has_float_at<Pose,
                    std::void_t<decltype(std::declval<const Pose&>().template at<float>(0, 0))>>
    : std::true_type {};

}  // namespace detail

/// Whether `host_pose` can read it (C++20: `concept HostPose`).
template <typename Pose>
inline constexpr bool is_host_pose_v = detail::has_matrix<std::remove_reference_t<Pose>>::value ||
                                       detail::has_float_at<std::remove_reference_t<Pose>>::value;

/// The pose of a host as double: of anything with `matrix()` (Sophus::SE3f, as in ORB-SLAM3, and
/// Eigen's own) or with `at<float>(row, column)` (a 4 × 4 cv::Mat, as in ORB-SLAM2). A rotation
/// that rounding left askew is put right; throws InvalidValue for what is no rigid motion.
template <typename Pose>
Eigen::Isometry3d host_pose(const Pose& pose) {
  static_assert(is_host_pose_v<Pose>,
                "topobag: a host's pose has matrix(), or at<float>(row, column) as a cv::Mat.");
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  if constexpr (detail::has_matrix<Pose>::value) {
    matrix = pose.matrix().template cast<double>();
  } else {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        matrix(row, column) = static_cast<double>(pose.template at<float>(row, column));
      }
    }
  }
  return nearest_rigid(matrix, "the host's pose", computed_rotation_tolerance);
}

}  // namespace v0
}  // namespace topobag
