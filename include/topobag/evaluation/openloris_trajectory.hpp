// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <charconv>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <topobag/evaluation/detail/pose_text.hpp>
#include <topobag/evaluation/trajectory.hpp>

namespace topobag {
inline namespace v0 {

/// The trajectories of one scene, by sequence number: one file of the lifelong SLAM benchmark
/// OpenLORIS-Scene (Shi et al., ICRA 2020).
struct LifelongTrajectories {
  std::string scene;                    ///< the `scene:` header; empty without one
  std::string frame;                    ///< the `frame:` header: whose poses these are
  std::map<int, Trajectory> sequences;  ///< by the number of the `seq:` header
};

/// What becomes of a pose equal to the last one kept: a system that has lost track may repeat it.
enum class RepeatedPoses {
  drop,  ///< the benchmark's default; across sequences too
  keep,
};

/// Where the colon behind the key of a `key: value` line is, a key being what begins with a letter;
/// npos for a line without one.
/// @param line  a `std::string_view` that is not empty
template <typename Text = std::string_view>
std::size_t openloris_header_end(const Text& line) noexcept {
  const char c = line.front();
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return letter ? line.find(':') : std::string_view::npos;
}

/// Reads an OpenLORIS-Scene result or ground-truth file: `key: value` headers, whose keys begin
/// with a letter (of which `scene`, `frame` and `seq` are used; the first `scene` and `frame`
/// count), then per pose `stamp tx ty tz qx qy qz qw` or `stamp another-stamp tx …`. Stamps may
/// come in any order in this format and are sorted. Throws Error with `name` and the line for
/// anything else, for a sequence that starts twice, for two poses of one sequence at the same time
/// and for stamps that are no seconds (`require_recording`).
/// @param stream  a `std::istream`
template <typename Stream>
LifelongTrajectories read_openloris(Stream& stream, const std::string& name,
                                    RepeatedPoses repeated = RepeatedPoses::drop) {
  TextLines lines(stream, name);
  LifelongTrajectories file;
  Trajectory* sequence = nullptr;
  std::vector<double> last_pose;
  std::string_view line;
  std::vector<double> numbers;
  while (lines.next(line)) {
    if (const std::size_t colon = openloris_header_end(line); colon != std::string_view::npos) {
      const std::string_view key = trimmed(line.substr(0, colon));
      const std::string_view value = trimmed(line.substr(colon + 1));
      if (key == "scene" && file.scene.empty()) file.scene = value;
      if (key == "frame" && file.frame.empty()) file.frame = value;
      if (key != "seq") continue;
      int number = 0;
      const auto [end, status] = std::from_chars(value.data(), value.data() + value.size(), number);
      if (status != std::errc{} || end != value.data() + value.size()) {
        throw lines.error("'" + std::string(value) + "' is not a sequence number.");
      }
      const auto [place, is_new] = file.sequences.try_emplace(number);
      if (!is_new)
        throw lines.error("sequence " + std::to_string(number) + " starts a second time.");
      sequence = &place->second;
      continue;
    }
    lines.numbers(line, numbers);
    if (numbers.size() != 8 && numbers.size() != 9) {
      throw lines.error(
          "a pose has 8 or 9 numbers, of which the last 7 are tx ty tz qx qy qz qw; here are " +
          std::to_string(numbers.size()) + ".");
    }
    if (sequence == nullptr) throw lines.error("a pose comes before the first 'seq:' header.");
    const double stamp = detail::stamp_of(lines, numbers);
    const Eigen::Isometry3d pose = detail::pose_from_quaternion(lines, &numbers.back() - 6);
    const std::vector<double> values(numbers.end() - 7, numbers.end());
    if (repeated == RepeatedPoses::drop && values == last_pose) continue;
    last_pose = values;
    const auto place =
        std::upper_bound(sequence->begin(), sequence->end(), stamp,
                         [](double t, const StampedPose& other) { return t < other.stamp; });
    if (place != sequence->begin() && (place - 1)->stamp == stamp) {
      throw lines.error("the sequence already has a pose at this time.");
    }
    sequence->insert(place, {stamp, pose});
  }
  for (const auto& [number, poses] : file.sequences) detail::require_recorded(name, poses);
  return file;
}

/// The same from a file.
/// @param path  a `std::string`, or what else converts to one
template <typename Path = std::string>
LifelongTrajectories read_openloris(const Path& path,
                                    RepeatedPoses repeated = RepeatedPoses::drop) {
  std::ifstream file = open_file(path);
  return read_openloris(file, path, repeated);
}

/// T_base_frame of a sensor of the OpenLORIS-Scene robot, as the data set publishes it: the ground
/// truth is of `base_link`, the systems' results are of a sensor. Nothing for an unknown frame.
/// @param frame  a `std::string_view`, or what else compares with a string
template <typename Text = std::string_view>
std::optional<Eigen::Isometry3d> openloris_T_base_frame(const Text& frame) {
  const auto pose = [](double tx, double ty, double tz, double qx, double qy, double qz,
                       double qw) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() << tx, ty, tz;
    T.linear() = Eigen::Quaterniond(qw, qx, qy, qz).normalized().toRotationMatrix();
    return T;
  };
  if (frame == "base_link") return Eigen::Isometry3d::Identity();
  if (frame == "d400_color") {
    return pose(0.2264836849091656, -0.05114194035652147, 0.916, -0.49676229968284136,
                0.4998795887129771, -0.49510681269354095, 0.5081504289345848);
  }
  if (frame == "d400_imu") {
    return pose(0.21545245195759705, -0.07164430142403165, 0.9206998887739904, -0.49538006860636935,
                0.49954735142309487, -0.49840674562280746, 0.5065982108450463);
  }
  if (frame == "t265_fisheye1") {
    return pose(0.23757012582874237, -0.038724749600647444, 0.8950755692783204,
                -0.49597362846259985, 0.49833071591566835, -0.4958921122758979, 0.5096740825539088);
  }
  return std::nullopt;
}

}  // namespace v0
}  // namespace topobag
