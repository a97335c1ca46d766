// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <topobag/evaluation/detail/pose_text.hpp>
#include <topobag/evaluation/trajectory.hpp>

namespace topobag {
inline namespace v0 {

/// Whether a header of columns names a quaternion's w before its x, as EuRoC's and other ASL data
/// sets do: `#timestamp [ns],…,q_RS_w [],q_RS_x [],…`.
/// @param header  a `std::string_view`
template <typename Text = std::string_view>
bool names_w_first(const Text& header) {
  const auto place_of = [&](char axis) {
    for (std::size_t at = 0; (at = header.find('q', at)) != std::string_view::npos; ++at) {
      const std::size_t end = std::min(header.find_first_of(", \t[", at), header.size());
      const bool begins = at == 0 || std::string_view("#, \t").find(header[at - 1]) <= 3;
      if (begins && end - at > 1 && header[end - 1] == axis) return at;
    }
    return std::string_view::npos;
  };
  const std::size_t w = place_of('w'), x = place_of('x');
  return w != std::string_view::npos && x != std::string_view::npos && w < x;
}

namespace detail {

/// Throws Error where the comment above the first pose names w first: numbers would be taken for
/// others.
template <typename Lines>
void require_w_last(const Lines& lines) {
  if (!names_w_first(lines.heading())) return;
  throw lines.error(
      "the header above names the quaternion's w first, as EuRoC's files do; write timestamp tx ty "
      "tz qx qy qz qw, the time in seconds (nanoseconds divided by 1e9), w last and nothing "
      "behind it");
}

}  // namespace detail

/// Reads the TUM format: `timestamp tx ty tz qx qy qz qw` per line, seconds and metres, separated
/// by blanks or commas, `#` comments. Quaternions within 0.01 of unit length are normalised. Throws
/// Error with `name` and the line for anything else, such as a header that names w first, and for
/// stamps that do not increase or are no seconds (`require_recording`).
/// @param stream  a `std::istream`
template <typename Stream>
Trajectory read_tum(Stream& stream, const std::string& name) {
  TextLines lines(stream, name);
  Trajectory trajectory;
  std::string_view line;
  std::vector<double> numbers;
  while (lines.next(line)) {
    if (trajectory.empty()) detail::require_w_last(lines);
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
  detail::require_recorded(name, trajectory);
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
