// SPDX-License-Identifier: MIT
#include "pose_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include <topobag/evaluation/kitti_trajectory.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>

#include "csv_pose.hpp"
#include "csv_reader.hpp"
#include "path_kind.hpp"
#include "recorded.hpp"

namespace program {
namespace {

PoseFormat format_of(const std::string& path) {
  std::istringstream stream(read_file(path));
  topobag::TextLines lines(stream, path);
  std::string_view line;
  if (!lines.next(line)) throw InputError(path, "there is no pose in the file");
  std::vector<std::string_view> fields;
  topobag::TextLines::split(line, fields);
  const bool mixed = std::any_of(fields.begin(), fields.end(), [](std::string_view field) {
    return field.find_first_of("; ") != std::string_view::npos;
  });
  if (mixed && std::isdigit(static_cast<unsigned char>(line.front())) != 0) {
    throw lines.error(
        "numbers are separated by blanks or by commas, not by semicolons, and decimals have a "
        "point");
  }
  if (topobag::parse_number(fields.front())) {
    if (fields.size() == 12) return PoseFormat::kitti;
    if (fields.size() == 8 || topobag::names_w_first(lines.heading())) return PoseFormat::tum;
    throw lines.error("here are " + std::to_string(fields.size()) +
                      " numbers; poses are lines of 8 (TUM: timestamp tx ty tz qx qy qz qw) or 12 "
                      "(KITTI: a 3 x 4 matrix)");
  }
  const bool named = std::find(fields.begin(), fields.end(), "timestamp") != fields.end();
  if (named) return PoseFormat::frames;
  if (topobag::openloris_header_end(line) != std::string_view::npos) return PoseFormat::openloris;
  throw lines.error(
      "this begins no file of poses: neither numbers (TUM, KITTI) nor 'key: value' (OpenLORIS) nor "
      "a header that names 'timestamp' (SET.frames.csv)");
}

topobag::Trajectory read_frame_poses(const std::string& path) {
  CsvReader csv(path);
  const std::size_t timestamp = csv.column("timestamp");
  csv.column("tx");
  const CsvPose pose(csv);
  topobag::Trajectory trajectory;
  while (csv.next()) {
    const double stamp = csv.seconds(timestamp);
    const auto T_world_camera = pose.read();
    if (!T_world_camera) throw csv.error("the frame has no pose");
    if (!trajectory.empty() && !(stamp > trajectory.back().stamp)) {
      throw csv.error("the timestamp is not later than the one before");
    }
    trajectory.push_back({stamp, *T_world_camera});
  }
  require_recorded(path, trajectory, [](const topobag::StampedPose& one) { return one.stamp; });
  return trajectory;
}

}  // namespace

PoseFile read_pose_file(const std::string& name, const std::string& times,
                        topobag::RepeatedPoses repeated) {
  const bool is_set = !std::filesystem::exists(name) && path_kind(name) == PathKind::table;
  const std::string path = is_set ? name + ".frames.csv" : name;
  PoseFile file;
  file.format = format_of(path);
  file.stamped = file.format != PoseFormat::kitti || !times.empty();
  topobag::Trajectory single;
  switch (file.format) {
    case PoseFormat::openloris:
      file.content = topobag::read_openloris(path, repeated);
      break;
    case PoseFormat::frames:
      single = read_frame_poses(path);
      break;
    case PoseFormat::tum:
      single = topobag::read_tum(path);
      break;
    case PoseFormat::kitti:
      single = topobag::read_kitti(path);
      if (!times.empty()) {
        std::istringstream stream(read_file(times));
        topobag::read_kitti_times(stream, times, single);
      }
      break;
  }
  if (!single.empty()) file.content.sequences[1] = std::move(single);
  const auto& sequences = file.content.sequences;
  if (std::all_of(sequences.begin(), sequences.end(),
                  [](const auto& sequence) { return sequence.second.empty(); })) {
    throw InputError(path, "there is no pose in the file");
  }
  return file;
}

topobag::Trajectory read_trajectory(const std::string& path, const std::string& times) {
  const PoseFile file = read_pose_file(path, times, topobag::RepeatedPoses::keep);
  if (!times.empty() && file.format != PoseFormat::kitti) {
    throw InputError(path, "only a KITTI trajectory goes with a file of times");
  }
  if (file.content.sequences.size() != 1) {
    throw InputError(path, "the file does not hold one trajectory; give one sequence");
  }
  return file.content.sequences.begin()->second;
}

std::string span_text(const topobag::Trajectory& trajectory) {
  std::ostringstream text;
  text.precision(15);
  text << trajectory.size() << " poses";
  if (!trajectory.empty()) {
    text << " from " << trajectory.front().stamp << " to " << trajectory.back().stamp << " s";
  }
  return text.str();
}

}  // namespace program
