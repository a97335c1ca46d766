// SPDX-License-Identifier: MIT
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <topobag/evaluation/labelled_scores.hpp>
#include <topobag/evaluation/protocol_text.hpp>

#include "commands.hpp"
#include "csv_reader.hpp"
#include "number_check.hpp"
#include "option_use.hpp"
#include "output_files.hpp"
#include "pair_scores.hpp"
#include "pose_files.hpp"
#include "progress.hpp"
#include "report/report_options.hpp"
#include "report/retrieval_page.hpp"
#include "retrieval_report.hpp"

namespace program {
namespace {

struct EvaluateOptions {
  std::string scores;
  std::string against;
  std::string poses;
  std::string map_poses;
  std::string times;
  std::string protocol = default_protocol;
  bool lower_is_better = false;
  bool as_json = false;
  std::vector<double> pose_limits;
  std::optional<double> accept;
  std::string curve;
  std::string ranks;
  RetrievalReportOptions report;
  ReportFiles files;
};

/// The scores of a method, higher = more alike, with what the truth says of them.
struct Method {
  topobag::LabelledScores labelled;
  PairScores scores;
};

Method read_method(const std::string& path, const EvaluateOptions& options,
                   const topobag::PlaceTruth& truth) {
  Method method;
  method.scores = read_pair_scores(path, options.lower_is_better);
  method.labelled = label_scores(method.scores, truth, path);
  return method;
}

KnownPlaces read_places(const EvaluateOptions& options) {
  const topobag::PlaceProtocol protocol = topobag::parse_protocol(options.protocol);
  const std::vector<std::string> files{options.poses, options.map_poses};
  for (std::size_t i = 0; i < files.size() && protocol.exclude_seconds > 0.0; ++i) {
    if (files[i].empty() || read_pose_file(files[i], i == 0 ? options.times : "").stamped) continue;
    throw InputError(files[i],
                     "exclude-seconds needs times, which a KITTI trajectory has not: give "
                     "--times, or exclude-frames");
  }
  topobag::Trajectory queries = read_trajectory(options.poses, options.times);
  if (options.map_poses.empty()) {
    const topobag::PlaceTruth truth(protocol, queries);
    return {queries, queries, truth, protocol.frustum};
  }
  topobag::Trajectory map = read_trajectory(options.map_poses);
  const topobag::PlaceTruth truth(protocol, queries, map);
  return {std::move(queries), std::move(map), truth, protocol.frustum};
}

topobag::PoseLimits read_limits(const std::vector<double>& v) {
  if (v.empty()) return {};
  const topobag::PoseLimits limits{v[0], v[1], v[2], v[3]};
  if (!(v[0] >= 0.0 && v[1] >= 0.0 && v[2] >= v[0] && v[3] >= v[1])) {
    throw InputError("--pose-limits",
                     "a limit is negative, or a wrong limit below its correct one");
  }
  return limits;
}

/// The score from which on a pair is accepted, higher = more alike.
std::optional<double> least_score(const EvaluateOptions& options) {
  if (!options.accept) return std::nullopt;
  return options.report.score_sign * *options.accept;
}

Json loops_json(const EvaluateOptions& options, const topobag::ScoreList& list,
                const topobag::PlaceTruth& truth) {
  const topobag::PoseLimits limits = read_limits(options.pose_limits);
  const double least = least_score(options).value_or(-std::numeric_limits<double>::infinity());
  topobag::LoopVerdicts verdicts;
  for (std::size_t i = 0; i < list.pairs.size(); ++i) {
    const topobag::ScoredPair& pair = list.pairs[i];
    if (pair.score < least) continue;
    verdicts.add(
        topobag::judge_loop(truth, pair.query, pair.candidate, list.T_candidate_query[i], limits));
  }
  return verdicts_json(verdicts, limits);
}

/// Whether a method gives a loop's pose.
bool has_poses(const PairScores& scores) {
  const auto* const list = std::get_if<topobag::ScoreList>(&scores);
  return list != nullptr && !list->T_candidate_query.empty();
}

/// Throws where every ranking would be perfect and there is no pose to judge either.
void require_false_pairs(const topobag::PlaceTruth& truth, const PairScores& scores) {
  if (has_poses(scores) || count_pairs(truth, topobag::PairRelation::negative) > 0) return;
  throw InputError("--protocol " + topobag::to_string(truth.protocol()),
                   "it calls no pair false, so that there is nothing to score; call fewer places "
                   "true, or give poses of other places too");
}

/// Throws where an option is about the poses of scores that have none.
void require_loop_poses(const EvaluateOptions& options, const PairScores& scores) {
  const bool accepts = options.accept && !wanted(options.files);  // a report has best answers too
  const char* const option = !options.pose_limits.empty() ? "--pose-limits"
                             : accepts                    ? "--accept"
                                                          : nullptr;
  if (option == nullptr) return;
  if (has_poses(scores)) return;
  throw InputError(options.scores, std::string("its scores have no poses, which ") + option +
                                       " is about: a list with the columns tx,ty,tz,qx,qy,qz,qw "
                                       "has them");
}

void evaluate(const EvaluateOptions& options) {
  if (are_same_file(options.scores, options.against)) {
    throw InputError("--against " + options.against,
                     "these are the scores themselves; give those of another method");
  }
  const KnownPlaces places = read_places(options);
  const topobag::PlaceTruth& truth = places.truth;
  Method method = read_method(options.scores, options, truth);
  require_loop_poses(options, method.scores);
  require_false_pairs(truth, method.scores);
  Json result;
  result["scores"] = options.scores;
  result["poses"] = options.poses;
  if (!options.map_poses.empty()) result["map_poses"] = options.map_poses;
  result["protocol"] = topobag::to_string(truth.protocol());
  result.update(retrieval_json(method.labelled, options.report));
  if (has_poses(method.scores)) {
    result["loops"] = loops_json(options, std::get<topobag::ScoreList>(method.scores), truth);
  }
  Method other;
  if (!options.against.empty()) {
    other = read_method(options.against, options, truth);
    result["against"] = options.against;
    result["comparison"] = comparison_json(method.labelled, other.labelled, options.report);
  }
  if (!options.curve.empty()) write_file(options.curve, curve_csv(method.labelled, options.report));
  if (!options.ranks.empty()) write_file(options.ranks, ranks_csv(method.labelled));
  if (wanted(options.files)) {
    const double sign = options.report.score_sign;
    RetrievalRun run;
    run.methods.push_back({options.scores, std::move(method.labelled), sign});
    if (!options.against.empty()) {
      run.methods.push_back({options.against, std::move(other.labelled), sign});
    }
    run.scores = std::move(method.scores);
    run.one_trajectory = options.map_poses.empty();
    run.accept = least_score(options);
    run.limits = read_limits(options.pose_limits);
    write_report(retrieval_report(places, run), options.files);
  }
  std::cout << output_text(result, options.as_json);
}

}  // namespace

void add_evaluate_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "evaluate", "Scores any method's similarities against a declared definition of a true loop");
  const auto options = std::make_shared<EvaluateOptions>();
  topobag::ResamplingOptions& resampling = options->report.resampling;
  command
      .add_option("--scores", options->scores,
                  "Matrix (a row per query; .npy or CSV) or list (CSV with the header "
                  "query,candidate,score[,tx,ty,tz,qx,qy,qz,qw])")
      ->required();
  command
      .add_option("--poses", options->poses,
                  "True camera poses, a row per query: TUM, KITTI, OpenLORIS or SET.frames.csv")
      ->required();
  command.add_option("--map-poses", options->map_poses,
                     "True poses of the candidates [those of the queries: loops]");
  command.add_option("--times", options->times, "times.txt of KITTI poses");
  command
      .add_option(
          "--protocol", options->protocol,
          "What a true loop is: distance=M,angle=DEG,negative-distance=M,negative-angle=DEG,"
          "covisibility=C,negative-covisibility=C,frustum=fx:fy:cx:cy:w:h:near:far,"
          "exclude-seconds=S,exclude-frames=N,past-only")
      ->capture_default_str();
  command.add_flag("--lower-is-better", options->lower_is_better, "The scores are distances");
  command.add_option("--k", options->report.ks, "The K of Recall@K")
      ->delimiter(',')
      ->check(whole_number_from(1))
      ->capture_default_str();
  command
      .add_option("--bootstrap", resampling.resamples,
                  "Resamples of the queries for confidence intervals; 0 = none")
      ->check(whole_number_from(0))
      ->capture_default_str();
  command.add_option("--level", options->report.level, "Of the confidence intervals")
      ->check(number_within(0.01, 0.999))
      ->capture_default_str();
  command.add_option("--seed", resampling.seed, "Of the resamples")
      ->check(whole_number_from(0))
      ->capture_default_str();
  command.add_option("--against", options->against,
                     "Scores of another method: tests the difference, paired by query");
  command
      .add_option("--pose-limits", options->pose_limits,
                  "Of a loop's pose: correct m, correct deg, wrong m, wrong deg [0.3 15 1 45]")
      ->expected(4)
      ->delimiter(',');
  command
      .add_option("--accept", options->accept,
                  "Score from which on a pair with a pose is an accepted loop [every pair]")
      ->check(any_number());
  add_output_option(command, "--curve", options->curve, "CSV to write: the precision-recall curve");
  add_output_option(command, "--ranks", options->ranks,
                    "CSV to write: each query's first true answer");
  add_report_options(command, options->files);
  add_progress_option(command);
  command.add_flag("--json", options->as_json, "Print JSON");
  command.callback([options, &command] {
    require_with(command, "--level", {"--bootstrap", "--against"});
    require_with(command, "--seed", {"--bootstrap", "--against"});
    options->report.score_sign = options->lower_is_better ? -1.0 : 1.0;
    evaluate(*options);
  });
}

}  // namespace program
