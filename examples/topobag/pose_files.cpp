// SPDX-License-Identifier: MIT
#include "pose_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>

#include <topobag/evaluation/kitti_trajectory.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>

#include "csv_reader.hpp"

namespace program {
namespace {

PoseFormat format_of(const std::string& path) {
  std::istringstream lines(read_file(path));
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    if (line.find(':') != std::string::npos) return PoseFormat::openloris;
    if (line.find(',') != std::string::npos) return PoseFormat::frames;
    std::istringstream fields(line);
    const auto count = std::distance(std::istream_iterator<std::string>(fields), {});
    return count == 12 ? PoseFormat::kitti : PoseFormat::tum;
  }
  throw InputError(path, "there is no pose in the file");
}

topobag::Trajectory read_frame_poses(const std::string& path) {
  CsvReader csv(path);
  const std::array<const char*, 8> names{"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"};
  std::array<std::size_t, 8> columns{};
  for (std::size_t i = 0; i < names.size(); ++i) columns[i] = csv.column(names[i]);
  topobag::Trajectory trajectory;
  while (csv.next()) {
    std::array<double, 8> v{};
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = csv.number(columns[i]);
    const Eigen::Quaterniond rotation(v[7], v[4], v[5], v[6]);
    if (std::abs(rotation.norm() - 1.0) > 0.01) {
      throw csv.error("the quaternion qx qy qz qw does not have unit length");
    }
    if (!trajectory.empty() && !(v[0] > trajectory.back().stamp_s)) {
      throw csv.error("the timestamp is not later than the one before");
    }
    trajectory.push_back({v[0], Eigen::Translation3d(v[1], v[2], v[3]) * rotation.normalized()});
  }
  return trajectory;
}

}  // namespace

PoseFile read_pose_file(const std::string& path, const std::string& times,
                        topobag::RepeatedPoses repeated) {
  PoseFile file;
  file.format = format_of(path);
  topobag::Trajectory& single = file.content.sequences[1];
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

}  // namespace program
