// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "detected_nodes.hpp"
#include "rgbd_sequence.hpp"

namespace program {

/// The row of a frame that nothing was detected in yet.
FrameRow row_of(const RgbdFrame& frame, std::size_t idx);

/// The table that a run of `nodes` has made so far, kept beside the one to be: whatever ends the
/// run, the same command goes on from there.
class NodesCheckpoint {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param set        table to be; SET.partial.* hold the one so far
  /// @param made_with  all that the detections depend on; a table made with other things is no
  ///                   beginning of this one
  /// @param catalog    of the table's classes
  /// @param pause      from one time that the table is kept to the next
  NodesCheckpoint(const std::string& set, std::string made_with,
                  topobag::ClassCatalog catalog = topobag::ClassCatalog::coco80(),
                  Clock::duration pause = std::chrono::seconds(10));

  /// What an earlier run got done of the frames, from the first one on.
  DetectedNodes earlier(const std::vector<RgbdFrame>& frames) const;

  /// Throws InputError where an earlier run with other options, or of other images, got some frames
  /// done: they would be written over.
  void require_own(const std::vector<RgbdFrame>& frames) const;

  /// Keeps the table so far when it is time to. Throws InputError.
  void keep(const DetectedNodes& detected);

  /// Forgets it: the whole table is written.
  void remove() const;

 private:
  std::string set_;
  std::string made_with_;
  topobag::ClassCatalog catalog_;
  Clock::duration pause_;
  Clock::time_point kept_ = Clock::now();
};

}  // namespace program
