// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>

#include <topobag/adaptors/orb_slam/fused_window.hpp>
#include <topobag/graph/local_graph_options.hpp>
#include <topobag/recognition/recognition_options.hpp>

namespace topobag {
inline namespace v0 {

/// What the adaptor takes of the library, and how much it offers the host.
struct OrbSlamOptions {
  LocalGraphOptions fusing{};  ///< key frames of `window` s make one graph; 0 = single ones
  /// Retrieval, matching and decision; for loops, merges and re-localization each. A filter of the
  /// retrieval must not call the data base, and sees poses as `HostWorlds` has them.
  RecognitionOptions recognition = few_candidates(3);
  std::size_t max_loops = 5;            ///< verified places offered for a loop, and for a merge
  std::size_t max_relocalizations = 5;  ///< places offered to a lost tracker, guesses among them
  /// s between the key frames of a loop, which those of other maps need not keep; beside the host's
  /// rule that covisible ones make none. Nearer ones are the present visit.
  double min_loop_gap = 20.0;
  std::chrono::milliseconds loop_wait{200};  ///< a loop query waits this long for a sighting
                                             ///< that was not given up
  StaleTolerance stale{};                    ///< `refresh_changed` makes a graph anew beyond it

  /// The defaults, but fewer key frames are matched: tracking waits for the answer.
  static RecognitionOptions few_candidates(std::size_t count) {
    RecognitionOptions options;
    options.retrieval.max_results = count;
    return options;
  }
};

}  // namespace v0
}  // namespace topobag
