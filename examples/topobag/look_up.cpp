// SPDX-License-Identifier: MIT
#include "look_up.hpp"

#include <utility>

#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/types/class_catalog.hpp>

#include "stopwatch.hpp"

namespace program {
namespace {

/// The library's defaults, for the classes of a node table.
topobag::RecognitionOptions table_recognition_options() {
  topobag::RecognitionOptions options;
  options.matching.consistency.classes =
      topobag::lookalike_classes(topobag::ClassCatalog::coco80());
  return options;
}

topobag::Relocalizer<> relocalizer_of(const std::vector<Keyframe>& map) {
  topobag::Relocalizer<> relocalizer(table_recognition_options());
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!map[i].graph.is_matchable()) continue;
    relocalizer.map().add(topobag::KeyframeId{i}, map[i].graph);
  }
  return relocalizer;
}

/// What `recognize` says, and the time it took.
template <typename Recognize>
LookUp timed(const Recognize& recognize) {
  const Stopwatch watch;
  topobag::Recognition recognition = recognize();
  return {std::move(recognition), watch.milliseconds(), {}, {}};
}

}  // namespace

void look_up_in_map(RecognitionRun& run) {
  const topobag::Relocalizer<> relocalizer = relocalizer_of(run.map);
  run.look_ups.clear();
  for (const Keyframe& query : run.queries) {
    run.look_ups.push_back(timed([&] { return relocalizer.localize(query.graph); }));
  }
}

void look_up_earlier(RecognitionRun& run, double min_gap) {
  topobag::LoopDetector<> loops({min_gap, table_recognition_options()});
  run.look_ups.clear();
  for (std::size_t i = 0; i < run.queries.size(); ++i) {
    const Keyframe& query = run.queries[i];
    run.look_ups.push_back(timed([&] { return loops.detect(query.timestamp, query.graph); }));
    if (!query.graph.is_matchable()) continue;
    topobag::EntryInfo info;
    info.stamp = query.timestamp;
    loops.bag().add(topobag::KeyframeId{i}, query.graph, std::move(info));
  }
}

void verify(RecognitionRun& run, const std::vector<std::vector<topobag::Candidate>>& candidates) {
  const topobag::Relocalizer<> relocalizer = relocalizer_of(run.map);
  const topobag::RecognitionOptions& options = relocalizer.options();
  run.look_ups.clear();
  for (std::size_t i = 0; i < run.queries.size(); ++i) {
    run.look_ups.push_back(timed([&] {
      return topobag::verify_candidates(relocalizer.map(), run.queries[i].graph, candidates[i],
                                        options.matching, options.decision);
    }));
  }
}

}  // namespace program
