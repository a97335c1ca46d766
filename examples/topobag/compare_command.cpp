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

/// A method's best answers to each query, among the pairs that the protocol evaluates or ignores.
std::vector<std::vector<topobag::Candidate>> best_answers(const PairScores& scores,
                                                          const topobag::PlaceTruth& truth,
                                                          std::size_t count) {
  std::vector<std::vector<topobag::Candidate>> answers(truth.num_queries());
  for_each_score(scores, [&](std::size_t query, std::size_t candidate, double score) {
    if (truth.relation(query, candidate) == topobag::PairRelation::excluded) return;
    answers[query].push_back({topobag::KeyframeId{candidate}, score});
  });
  for (auto& of_query : answers) {
    std::sort(of_query.begin(), of_query.end());
    of_query.resize(std::min(count, of_query.size()));
  }
  return answers;
}

/// Time of all queries over the pairs that they verified, µs.
double verification_us(const RecognitionRun& run) {
  double milliseconds = 0.0;
  std::size_t pairs = 0;
  for (const QueryRecord& record : run.records) {
    milliseconds += record.milliseconds;
    pairs += record.tried.size();
  }
  return 1e3 * milliseconds / static_cast<double>(std::max<std::size_t>(1, pairs));
}

/// The library at its defaults.
ComparedMethod default_method(const RecognitionRun& run, const topobag::ScoreMatrix& scores,
                              const topobag::PlaceTruth& truth) {
  ComparedMethod method{
      "default", "the library: retrieval, all verified, ranked by verification and viewpoint"};
  method.labelled = topobag::label_scores(scores, truth);
  method.pair_us = verification_us(run);
  method.poses = summarize(run);
  return method;
}

/// The paper's whole pipeline: only what hardly moves, single frames, Delaunay in the image,
/// eq. 12.
ComparedMethod paper_method(const CompareArguments& arguments, const topobag::PlaceTruth& truth) {
  KeyframeOptions keyframes = arguments.keyframes;
  keyframes.window = 0.0;
  keyframes.keep = {topobag::Dynamics::low};
  keyframes.matchable = false;
  const RecognitionRun run = read_run(arguments, keyframes);
  const SimilarityScores scores = score_padded_cosine(run.queries, run.map);
  ComparedMethod method{"paper's whole pipeline",
                        "static objects, single frames, image Delaunay, eq. 12; no pose"};
  method.labelled = topobag::label_scores(scores.scores, truth);
  method.pair_us = scores.pair_us;
  return method;
}

/// What the library's verification makes of a method's best answers.
RunSummary verified(RecognitionRun& run, const PairScores& scores, const topobag::PlaceTruth& truth,
                    std::size_t count) {
  verify(run, best_answers(scores, truth, count));
  score(run, Scoring{});
  return summarize(run);
}

/// A method of the user's own, by its scores of the key frames of query and map.
ComparedMethod own_method(RecognitionRun& run, const std::string& path, const std::string& name,
                          const topobag::PlaceTruth& truth, const Comparison& comparison) {
  const PairScores scores = read_pair_scores(path, false);
  ComparedMethod method{name, "scores of " + path, label_scores(scores, truth, path)};
  method.meaning += unscored_text(method.labelled, comparison.true_pairs + comparison.false_pairs);
  method.poses = verified(run, scores, truth, comparison.verified);
  return method;
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
    comparison.methods.push_back(paper_method(arguments, places.truth));
  }
  for (std::size_t i = 0; i < own_names.size(); ++i) {
    const ProgressPart part = part_of_next();
    comparison.methods.push_back(
        own_method(run, arguments.own_scores[i], own_names[i], places.truth, comparison));
  }
  for (SimilarityScores& similarity : similarities) {
    const ProgressPart part = part_of_next();
    ComparedMethod method{std::move(similarity.name), std::move(similarity.meaning),
                          topobag::label_scores(similarity.scores, places.truth),
                          similarity.pair_us};
    method.poses = verified(run, std::move(similarity.scores), places.truth, arguments.verified);
    comparison.methods.push_back(std::move(method));
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
