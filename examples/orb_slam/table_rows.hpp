// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/types/ranged_detection.hpp>

#include <node_table.hpp>

#include "tum_sequence.hpp"

namespace semantic {

/// The boxes of node tables, by the stamps of their images.
class TableRows {
 public:
  using Boxes = std::vector<topobag::RangedDetection>;

  /// Throws topobag::Error when a table cannot be read.
  explicit TableRows(const std::vector<std::string>& tables) {
    for (const std::string& table : tables) {
      for (program::FrameRow& frame : program::read_node_table(table).frames) {
        rows_[frame.timestamp] = std::move(frame.detections);
      }
    }
  }

  /// The boxes of the image of this stamp, to 10 microseconds; null where no table has it.
  const Boxes* find(double stamp) const {
    const auto found = rows_.lower_bound(stamp - 1e-5);
    return found == rows_.end() || found->first > stamp + 1e-5 ? nullptr : &found->second;
  }

  /// Throws topobag::Error when the tables have none of the images, for then they are of another
  /// sequence.
  /// @param wanted  the option that should name the table
  void require_some_of(const std::vector<FramePaths>& frames, const std::string& wanted) const {
    const bool some = std::any_of(frames.begin(), frames.end(),
                                  [this](const auto& frame) { return find(frame.stamp); });
    if (some || frames.empty()) return;
    throw topobag::Error(frames.front().rgb + ": no table has this image, nor any other of its " +
                         "sequence; name the table of the sequence with " + wanted);
  }

 private:
  std::map<double, Boxes> rows_;
};

}  // namespace semantic
