// SPDX-License-Identifier: MIT
#pragma once

#include <istream>
#include <string>
#include <vector>

#include <topobag/evaluation/detail/pose_text.hpp>
#include <topobag/evaluation/trajectory.hpp>

namespace topobag {
inline namespace v0 {

/// Reads the KITTI odometry format: the 12 numbers of a row-major 3×4 matrix [R | t] per line. The
/// format has no time, so stamps are 0, 1, 2, …; see `read_kitti_times`. Rotations within 0.01 of
/// orthonormal are normalised. Throws Error with `name` and the line for anything else.
/// @param stream  a `std::istream`
template <typename Stream>
Trajectory read_kitti(Stream& stream, const std::string& name) {
  TextLines lines(stream, name);
  Trajectory trajectory;
  std::string_view line;
  std::vector<double> numbers;
  while (lines.next(line)) {
    lines.numbers(line, numbers);
    if (numbers.size() != 12) {
      throw lines.error("a KITTI trajectory has 12 numbers a line, a 3×4 matrix; here are " +
                        std::to_string(numbers.size()) + ".");
    }
    trajectory.push_back(
        {static_cast<double>(trajectory.size()), detail::pose_from_matrix(lines, numbers.data())});
  }
  return trajectory;
}

/// The same from a file.
/// @param path  a `std::string`, or what else converts to one
template <typename Path = std::string>
Trajectory read_kitti(const Path& path) {
  std::ifstream file = open_file(path);
  return read_kitti(file, path);
}

/// Gives a KITTI trajectory the stamps of its `times.txt`, one number of seconds per line. Throws
/// Error, and leaves the trajectory alone, when the numbers differ, or stamps do not increase or
/// are no seconds (`require_recording`).
/// @param stream  a `std::istream`
template <typename Stream>
void read_kitti_times(Stream& stream, const std::string& name, Trajectory& trajectory) {
  TextLines lines(stream, name);
  std::vector<double> stamps;
  std::string_view line;
  std::vector<double> numbers;
  while (lines.next(line)) {
    lines.numbers(line, numbers);
    if (numbers.size() != 1) throw lines.error("a line has one number, the time in seconds.");
    const bool first = stamps.empty();
    stamps.push_back(detail::later_stamp(lines, numbers, first, first ? 0.0 : stamps.back()));
  }
  if (stamps.size() != trajectory.size()) {
    throw Error(name + " has " + std::to_string(stamps.size()) + " times for " +
                std::to_string(trajectory.size()) + " poses.");
  }
  detail::require_recorded(name, stamps);
  for (std::size_t i = 0; i < stamps.size(); ++i) trajectory[i].stamp = stamps[i];
}

}  // namespace v0
}  // namespace topobag
