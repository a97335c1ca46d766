// SPDX-License-Identifier: MIT
#pragma once

#include <istream>
#include <ostream>
#include <string>
#include <vector>

#include <topobag/evaluation/detail/pose_text.hpp>
#include <topobag/evaluation/trajectory.hpp>

namespace topobag {
inline namespace v0 {

/// Reads the TUM format: `timestamp tx ty tz qx qy qz qw` per line, seconds and metres, separated
/// by blanks or commas, `#` comments. Quaternions within 0.01 of unit length are normalised. Throws
/// Error with `name` and the line for anything else, and for stamps that do not increase.
/// @param stream  a `std::istream`
template <typename Stream>
Trajectory read_tum(Stream& stream, const std::string& name) {
  TextLines lines(stream, name);
  Trajectory trajectory;
  std::string_view line;
  std::vector<double> numbers;
  while (lines.next(line)) {
    lines.numbers(line, numbers);
    if (numbers.size() != 8) {
      throw lines.error(
          "a TUM trajectory has 8 numbers a line: timestamp tx ty tz qx qy qz qw; here are " +
          std::to_string(numbers.size()) + ".");
    }
    const bool first = trajectory.empty();
    const double stamp =
        detail::later_stamp(lines, numbers, first, first ? 0.0 : trajectory.back().stamp);
    trajectory.push_back({stamp, detail::pose_from_quaternion(lines, numbers.data() + 1)});
  }
  return trajectory;
}

/// The same from a file.
/// @param path  a `std::string`, or what else converts to one
template <typename Path = std::string>
Trajectory read_tum(const Path& path) {
  std::ifstream file = open_file(path);
  return read_tum(file, path);
}

/// Writes the TUM format so that reading it back gives the same stamps and positions bit for bit,
/// whatever the locale.
/// @param trajectory  a `Trajectory`, or another range of `StampedPose`
template <typename Poses = Trajectory>
void write_tum(std::ostream& stream, const Poses& trajectory) {
  for (const auto& pose : trajectory) {
    write_number(stream, pose.stamp);
    detail::write_pose(stream.put(' '), pose.T_world_body);
    stream.put('\n');
  }
}

}  // namespace v0
}  // namespace topobag
