// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/evaluation/protocol_text.hpp>

#include "commands.hpp"
#include "compared_methods.hpp"
#include "comparison.hpp"
#include "input_error.hpp"
#include "keyframe_options.hpp"
#include "look_up.hpp"
#include "number_check.hpp"
#include "option_use.hpp"
#include "pair_scores.hpp"
#include "place_scores.hpp"
#include "progress.hpp"
#include "report/comparison_page.hpp"
#include "report/report_options.hpp"
#include "report/run_outcomes.hpp"
#include "saved_map.hpp"
#include "score_names.hpp"
#include "similarity_scores.hpp"

namespace program {
namespace {

struct CompareArguments {
  std::string nodes;
  MapAndQuery tables;
  double min_gap = topobag::usual_loop_gap;  ///< s
  KeyframeOptions keyframes;
  ImageSize image_size;
  std::string protocol = default_protocol;
  std::vector<std::string> own_scores;  ///< files
  std::size_t verified = 10;
  bool json = false;
  bool markdown = false;
  ReportFiles files;

  bool one_sequence() const { return !nodes.empty(); }
};

RecognitionRun read_run(const CompareArguments& arguments, const KeyframeOptions& keyframes) {
  return arguments.one_sequence()
             ? read_sequence(arguments.nodes, keyframes, arguments.image_size)
             : read_map_and_query(arguments.tables, keyframes, arguments.image_size);
}

KnownPlaces places_of(const RecognitionRun& run, const CompareArguments& arguments) {
  auto queries = true_trajectory(run.queries);
  auto map = true_trajectory(run.map);
  const auto require = [](const auto& trajectory, const std::string& set, const char* option) {
    if (trajectory) return;
    throw InputError(set + ".frames.csv",
                     std::string("not every key frame has a pose; give ") + option);
  };
  require(queries, run.query_set, "--trajectory");
  require(map, run.map_set, "--map-trajectory");
  std::optional<double> loop_gap;
  if (arguments.one_sequence()) loop_gap = arguments.min_gap;
  return known_places(*std::move(queries), *std::move(map),
                      topobag::parse_protocol(arguments.protocol), loop_gap);
}

/// The key frames as the paper has them: what hardly moves, single frames.
RecognitionRun read_static_frames(const CompareArguments& arguments) {
  KeyframeOptions keyframes = arguments.keyframes;
  keyframes.window = 0.0;
  keyframes.keep = {topobag::Dynamics::low};
  keyframes.matchable = false;
  return read_run(arguments, keyframes);
}

void compare(const CompareArguments& arguments) {
  const std::string& map = arguments.tables.map;
  if (is_saved_map(map)) {
    throw InputError(map, "compare makes the graphs anew and needs a node table, not a saved map");
  }
  const std::vector<std::string> own_names = score_names(arguments.own_scores);
  RecognitionRun run = read_run(arguments, arguments.keyframes);
  const KnownPlaces places = places_of(run, arguments);
  Comparison comparison{run.map_set, run.query_set, topobag::to_string(places.truth.protocol()),
                        arguments.verified};

  run.kept = KeptCandidates::tried;
  if (arguments.one_sequence()) {
    look_up_earlier(run, arguments.min_gap);
  } else {
    look_up_in_map(run);
  }
  require_queries(run);
  comparison.true_pairs = count_pairs(places.truth, topobag::PairRelation::positive);
  comparison.false_pairs = count_pairs(places.truth, topobag::PairRelation::negative);
  if (comparison.true_pairs == 0) {
    throw InputError(run.query_set,
                     "no query has a true place in the map by the protocol " + comparison.protocol);
  }
  if (comparison.false_pairs == 0) {
    throw InputError("--protocol " + comparison.protocol,
                     "it calls no pair false, so that every ranking is right and nothing is "
                     "compared; call fewer places true, or give a map that holds others too");
  }
  score(run, Scoring{});
  const topobag::ScoreMatrix scores = place_scores(run);
  comparison.methods.push_back(default_method(run, scores, places.truth));
  DecidedScores decided{scores, outcomes_of(run, &places), run.scoring.limits,
                        arguments.one_sequence()};
  run.kept = KeptCandidates::best;
  std::vector<SimilarityScores> similarities = score_similarities(run.queries, run.map);
  const auto part_of_next = [&] {
    return ProgressPart("method", comparison.methods.size() + 1,
                        2 + arguments.own_scores.size() + similarities.size());
  };
  {
    const ProgressPart part = part_of_next();
    comparison.methods.push_back(paper_method(read_static_frames(arguments), places.truth));
  }
  for (std::size_t i = 0; i < own_names.size(); ++i) {
    const ProgressPart part = part_of_next();
    comparison.methods.push_back(
        own_method(run, arguments.own_scores[i], own_names[i], places.truth, comparison));
  }
  for (SimilarityScores& similarity : similarities) {
    const ProgressPart part = part_of_next();
    comparison.methods.push_back(
        similarity_method(run, std::move(similarity), places.truth, arguments.verified));
  }
  if (wanted(arguments.files)) {
    write_report(comparison_report(comparison, places, decided), arguments.files);
  }
  std::cout << (arguments.json       ? to_json(comparison)
                : arguments.markdown ? to_markdown(comparison)
                                     : to_table(comparison));
}

}  // namespace

void add_compare_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("compare", "Holds the similarities against each other on the same pairs");
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::Option* const nodes =
      command.add_option("--nodes", arguments->nodes, "Table whose earlier places are looked for");
  CLI::Option* const map =
      command.add_option("--map", arguments->tables.map, "Or: table of the map");
  CLI::Option* const query = command.add_option("--query", arguments->tables.query,
                                                "and table of the key frames to look up");
  nodes->excludes(map)->excludes(query);
  map->needs(query);
  query->needs(map);
  command
      .add_option("--min-gap", arguments->min_gap,
                  "With --nodes: age from which a key frame is an earlier visit, s")
      ->check(number_within(0.0))
      ->capture_default_str();
  add_keyframe_options(command, arguments->keyframes, arguments->image_size);
  add_map_options(command, arguments->tables);
  command.add_option("--protocol", arguments->protocol, "What a true place is, as in evaluate")
      ->capture_default_str();
  command
      .add_option("--verified", arguments->verified,
                  "Best answers of a similarity that are verified for a pose")
      ->check(whole_number_from(1))
      ->capture_default_str();
  command.add_option("--scores", arguments->own_scores,
                     "Also a method of your own, by its scores of the key frames: matrix or list, "
                     "as in evaluate; higher is better");
  add_report_options(command, arguments->files);
  command.add_flag("--json", arguments->json, "Report in JSON");
  command.add_flag("--markdown", arguments->markdown, "The table in Markdown")->excludes("--json");
  command.callback([arguments, &command] {
    require_stress_and_gravity(command);
    require_with(command, "--min-gap", {"--nodes"});
    if (!arguments->one_sequence() && arguments->tables.map.empty()) {
      throw InputError("give either --nodes or --map and --query");
    }
    compare(*arguments);
  });
}

}  // namespace program
