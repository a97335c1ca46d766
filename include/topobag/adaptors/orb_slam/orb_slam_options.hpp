// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>

#include <topobag/adaptors/orb_slam/fused_window.hpp>
#include <topobag/graph/local_graph_options.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/class_catalog.hpp>

namespace topobag {
inline namespace v0 {

/// What the adaptor takes of the library, and how much it offers the host.
struct OrbSlamOptions {
  LocalGraphOptions fusing{};  ///< key frames of `window` s make one graph; 0 = single ones
  /// Retrieval, matching and decision, which know no classes (`orb_slam_options` does); for loops,
  /// merges and re-localization each. A filter of the retrieval must not call the data base, and
  /// sees poses as `HostWorlds` has them.
  RecognitionOptions recognition = few_candidates(3);
  std::size_t max_loops = 5;            ///< verified places offered for a loop, and for a merge
  std::size_t max_relocalizations = 5;  ///< places offered to a lost tracker, guesses among them
  /// s between the key frames of a loop, which those of other maps need not keep; beside the host's
  /// rule that covisible ones make none. Nearer ones are the present visit.
  double min_loop_gap = usual_loop_gap;
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

/// The defaults for sightings with the labels of a catalog, as `recognition_options`: classes of it
/// that detectors mix up may be one object, and sizes differ as they usually do. What every host
/// should take whose detector's classes have a catalog.
///
///     OrbSlamDatabase<KeyFrame, Frame, Map> database(orb_slam_options(ClassCatalog::coco80()));
inline OrbSlamOptions orb_slam_options(const ClassCatalog& catalog,
                                       const SensorProfile& sensor = {}) {
  OrbSlamOptions options;
  const std::size_t few = options.recognition.retrieval.max_results;
  options.fusing = local_graph_options(sensor);
  options.recognition = recognition_options(catalog, sensor);
  options.recognition.retrieval.max_results = few;
  return options;
}

}  // namespace v0
}  // namespace topobag
