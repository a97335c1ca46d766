// SPDX-License-Identifier: MIT
#include "rgbd_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <topobag/evaluation/tum_trajectory.hpp>

#include "csv_reader.hpp"
#include "input_error.hpp"

namespace program {
namespace {

namespace fs = std::filesystem;

struct StampedFile {
  double timestamp = 0.0;  ///< s
  std::string path;
};

/// Reads lines of `entries` times "timestamp file"; files are relative to the list's folder.
std::vector<std::vector<StampedFile>> read_list(const fs::path& list, std::size_t entries) {
  std::vector<std::vector<StampedFile>> rows;
  std::istringstream lines(read_file(list.string()));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    std::istringstream fields(line);
    std::vector<StampedFile> row;
    for (std::string stamp, file; fields >> stamp >> file;) {
      const std::optional<double> timestamp = parse_number(stamp);
      if (!timestamp) {
        throw InputError(list.string(), number, "'" + stamp + "' is not a timestamp in seconds");
      }
      row.push_back({*timestamp, (list.parent_path() / file).string()});
    }
    if (row.size() != entries) {
      throw InputError(
          list.string(), number,
          "the line does not hold " + std::to_string(entries) + " times 'timestamp file'");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The depth image nearest in time, at most 20 ms away.
const StampedFile* nearest_depth(const std::vector<std::vector<StampedFile>>& depths, double time) {
  const StampedFile* nearest = nullptr;
  double best = 0.02;
  for (const auto& depth : depths) {
    const double gap = std::abs(depth.front().timestamp - time);
    if (gap <= best) {
      best = gap;
      nearest = &depth.front();
    }
  }
  return nearest;
}

std::vector<RgbdFrame> read_pairs(const fs::path& folder) {
  std::vector<RgbdFrame> frames;
  if (fs::exists(folder / "associations.txt")) {
    for (const auto& row : read_list(folder / "associations.txt", 2)) {
      frames.push_back({row[0].timestamp, row[0].path, row[1].path, std::nullopt});
    }
  } else {
    const auto depths = read_list(folder / "depth.txt", 1);
    for (const auto& row : read_list(folder / "rgb.txt", 1)) {
      if (const StampedFile* depth = nearest_depth(depths, row[0].timestamp)) {
        frames.push_back({row[0].timestamp, row[0].path, depth->path, std::nullopt});
      }
    }
  }
  if (frames.empty()) throw InputError(folder.string(), "no colour image has a depth image");
  std::stable_sort(frames.begin(), frames.end(), [](const RgbdFrame& a, const RgbdFrame& b) {
    return a.timestamp < b.timestamp;
  });
  return frames;
}

}  // namespace

std::vector<RgbdFrame> read_tum_sequence(const std::string& folder) {
  std::vector<RgbdFrame> frames = read_pairs(folder);
  const fs::path truth_file = fs::path(folder) / "groundtruth.txt";
  if (fs::exists(truth_file)) {
    const double max_gap_s = 0.1;
    const topobag::Trajectory truth = topobag::read_tum(truth_file.string());
    for (RgbdFrame& frame : frames) {
      frame.T_world_camera = topobag::pose_at(truth, frame.timestamp, max_gap_s);
    }
  }
  return frames;
}

}  // namespace program
