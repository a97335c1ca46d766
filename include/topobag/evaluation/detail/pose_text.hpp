// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <topobag/evaluation/number_text.hpp>
#include <topobag/evaluation/text_lines.hpp>
#include <topobag/evaluation/trajectory.hpp>
#include <topobag/types/rigid_motion.hpp>
#include <topobag/types/stamp.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The first of the current line's numbers as a time in seconds.
template <typename Lines>
double stamp_of(const Lines& lines, const std::vector<double>& numbers) {
  lines.located([&] { require_seconds(numbers[0]); });
  return numbers[0];
}

/// The same, later than the one before.
template <typename Lines>
double later_stamp(const Lines& lines, const std::vector<double>& numbers, bool first,
                   double before) {
  const double stamp = stamp_of(lines, numbers);
  if (!first && !(stamp > before)) {
    throw lines.error("the time stamp is not later than the one before.");
  }
  return stamp;
}

inline double seconds_of(double stamp) { return stamp; }
inline double seconds_of(const StampedPose& pose) { return pose.stamp; }

/// Throws Error with the file's name unless the stamps of a trajectory may be seconds.
/// @param frames  `StampedPose`, or stamps
template <typename Frames>
void require_recorded(const std::string& name, const Frames& frames) {
  try {
    require_recording(frames, [](const auto& frame) { return seconds_of(frame); });
  } catch (const InvalidValue& why) {
    throw Error(name + ": " + why.what());
  }
}

/// `tx ty tz qx qy qz qw` of the current line as a pose.
template <typename Lines>
Eigen::Isometry3d pose_from_quaternion(const Lines& lines, const double* values) {
  return lines.located([&] { return pose_from_numbers(values); });
}

/// A row-major 3×4 matrix [R | t] of the current line as a pose.
template <typename Lines>
Eigen::Isometry3d pose_from_matrix(const Lines& lines, const double* values) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topRows<3>() = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(values);
  return lines.located(
      [&] { return nearest_rigid(matrix, "the 3×4 matrix", written_rotation_tolerance); });
}

/// Writes `tx ty tz qx qy qz qw`.
inline void write_pose(std::ostream& stream, const Eigen::Isometry3d& T) {
  const Eigen::Vector3d t = T.translation();
  const Eigen::Quaterniond q(T.linear());
  write_number(stream, t.x());
  for (const double number : {t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
    write_number(stream.put(' '), number);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
