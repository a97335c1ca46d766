// SPDX-License-Identifier: MIT
#include "rgbd_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include <topobag/evaluation/text_lines.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>
#include <topobag/types/stamp.hpp>

#include "csv_reader.hpp"
#include "frame_poses.hpp"
#include "input_error.hpp"
#include "recorded.hpp"

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
  std::set<double> known;
  std::istringstream stream(read_file(list.string()));
  topobag::TextLines lines(stream, list.string());
  std::vector<std::string_view> fields;
  for (std::string_view line; lines.next(line);) {
    topobag::TextLines::split(line, fields);
    if (fields.size() != 2 * entries) {
      throw lines.error("the line does not hold " + std::to_string(entries) +
                        " times 'timestamp file'");
    }
    std::vector<StampedFile> row;
    for (std::size_t i = 0; i < fields.size(); i += 2) {
      const double timestamp = lines.number(fields[i]);
      lines.located([&] { topobag::require_seconds(timestamp); });
      row.push_back({timestamp, (list.parent_path() / fields[i + 1]).string()});
    }
    const double farthest = 0.1;  // s; a camera that takes ten depth images a second has one nearer
    const double gap = std::abs(row.back().timestamp - row.front().timestamp);
    const double rounding = 1e-6;  // s; of the stamps' last digit
    if (gap > farthest + rounding) {
      std::ostringstream why;
      why << "the two images are " << gap << " s apart, farther than " << farthest
          << " s; pair those of one moment";
      throw lines.error(why.str());
    }
    if (!known.insert(row.front().timestamp).second) {
      throw lines.error("an image of this time is there already; write each once");
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

RgbdSequence read_pairs(const fs::path& folder) {
  RgbdSequence sequence;
  std::vector<RgbdFrame>& frames = sequence.frames;
  if (fs::exists(folder / "associations.txt")) {
    for (const auto& row : read_list(folder / "associations.txt", 2)) {
      frames.push_back({row[0].timestamp, row[0].path, row[1].path, std::nullopt});
    }
  } else if (!fs::exists(folder)) {
    throw InputError(folder.string(), "there is no such folder");
  } else if (!fs::exists(folder / "depth.txt") && !fs::exists(folder / "rgb.txt")) {
    throw InputError(folder.string(),
                     "it is no sequence in the TUM RGB-D layout, which has associations.txt, or "
                     "rgb.txt and depth.txt");
  } else {
    const auto depths = read_list(folder / "depth.txt", 1);
    for (const auto& row : read_list(folder / "rgb.txt", 1)) {
      if (const StampedFile* depth = nearest_depth(depths, row[0].timestamp)) {
        frames.push_back({row[0].timestamp, row[0].path, depth->path, std::nullopt});
      } else {
        ++sequence.without_depth;
      }
    }
  }
  if (frames.empty()) throw InputError(folder.string(), "no colour image has a depth image");
  std::stable_sort(frames.begin(), frames.end(), [](const RgbdFrame& a, const RgbdFrame& b) {
    return a.timestamp < b.timestamp;
  });
  require_recorded(folder.string(), frames, [](const RgbdFrame& frame) { return frame.timestamp; });
  return sequence;
}

}  // namespace

RgbdSequence read_tum_sequence(const std::string& folder) {
  RgbdSequence sequence = read_pairs(folder);
  const fs::path truth = fs::path(folder) / "groundtruth.txt";
  if (fs::exists(truth)) {
    give_poses(truth.string(), topobag::read_tum(truth.string()), sequence.frames);
  }
  return sequence;
}

}  // namespace program
