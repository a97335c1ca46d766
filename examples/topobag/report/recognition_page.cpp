// SPDX-License-Identifier: MIT
#include "recognition_page.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <topobag/evaluation/protocol_text.hpp>

#include "calibration_report.hpp"
#include "csv_reader.hpp"
#include "html_text.hpp"
#include "match_figures.hpp"
#include "outcome_figures.hpp"
#include "output_files.hpp"
#include "pair_figures.hpp"
#include "recognition_report.hpp"
#include "run_conditions.hpp"
#include "run_outcomes.hpp"
#include "trajectory_figure.hpp"

namespace program {
namespace {

/// What the camera sees up to the depth of a room.
topobag::DepthFrustum room_frustum(const topobag::PinholeCamera<>& camera) {
  return {camera, 0.4, 4.0};
}

/// Makes the report of one run.
class RecognitionPage {
 public:
  RecognitionPage(const RecognitionRun& run, const RecognitionArguments& arguments,
                  const std::string& protocol, std::optional<double> loop_gap)
      : run_(run), arguments_(arguments), loop_gap_(loop_gap) {
    auto queries = true_trajectory(run.queries);
    auto map = true_trajectory(run.map);
    if (!queries || !map || arguments.scoring.different_places) return;
    places_ = known_places(*std::move(queries), *std::move(map), topobag::parse_protocol(protocol),
                           loop_gap);
    if (!places_->frustum) {
      places_->frustum = room_frustum(with_size(arguments.keyframes.camera, arguments.image_size));
    }
  }

  Report report() const;
  DataTable pairs() const { return pair_table(run_, places()); }

 private:
  void add_facts(Report& report, const std::vector<QueryOutcome>& outcomes) const;
  const KnownPlaces* places() const { return places_ ? &*places_ : nullptr; }

  const RecognitionRun& run_;
  const RecognitionArguments& arguments_;
  std::optional<double> loop_gap_;
  std::optional<KnownPlaces> places_;
};

void RecognitionPage::add_facts(Report& report, const std::vector<QueryOutcome>& outcomes) const {
  const RunSummary summary = summarize(run_);
  const KeyframeOptions& keyframes = arguments_.keyframes;
  const topobag::PoseLimits& limits = arguments_.scoring.limits;
  const auto count = [](std::size_t number) { return std::to_string(number); };
  auto& facts = report.facts;
  facts.emplace_back("Accepted", count(summary.accepted) + " of " + count(summary.queries) +
                                     " queries with a usable graph and a candidate");
  facts.emplace_back("Verdicts", count(summary.correct) + " correct, " + count(summary.imprecise) +
                                     " imprecise, " + count(summary.wrong) + " wrong, " +
                                     count(summary.unscored) + " not scored");
  facts.emplace_back(loop_gap_ ? "Sequence" : "Map",
                     run_.map_set + ", " + count(run_.map.size()) + " key frames");
  if (!loop_gap_) {
    facts.emplace_back("Queries",
                       run_.query_set + ", " + count(run_.queries.size()) + " key frames");
  }
  facts.emplace_back(
      "Key frames",
      (keyframes.interval > 0.0 ? "every " + short_text(keyframes.interval) + " s" : "all frames") +
          (keyframes.window > 0.0 ? ", graphs fused over " + short_text(keyframes.window) + " s"
                                  : ", graphs of single frames") +
          ", detections from score " + short_text(keyframes.min_confidence));
  if (summary.median_translation_error_m) {
    facts.emplace_back("Median error of the accepted",
                       fixed_text(*summary.median_translation_error_m, 3) + " m, " +
                           fixed_text(*summary.median_rotation_error_deg, 1) + "°");
  }
  if (summary.query_ms) facts.emplace_back("Time of a query", times_text(*summary.query_ms));
  if (run_.calibrated) {
    facts.emplace_back("Score asked for", threshold_text(*run_.calibrated));
    const std::string other = other_map_text(*run_.calibrated);
    if (!other.empty()) facts.emplace_back("Learnt", other);
    const topobag::CarryOver carry_over = run_.calibrated->calibration.carries_over();
    if (!carry_over) report.notes.push_back(carry_over.reason);
  }
  facts.emplace_back("Correct is", "up to " + short_text(limits.correct_translation_m) + " m and " +
                                       short_text(limits.correct_rotation_deg) + "°; wrong " +
                                       wrong_text(run_));
  const std::string left_out = left_out_text(run_);
  if (!left_out.empty()) facts.emplace_back("Left out", left_out);
  if (places_) {
    const auto true_places =
        std::count_if(outcomes.begin(), outcomes.end(),
                      [](const QueryOutcome& q) { return q.place.has_value(); });
    facts.emplace_back("Queries with a true place", std::to_string(true_places));
    facts.emplace_back("Protocol: what a true place is",
                       topobag::to_string(places_->truth.protocol()));
    const auto& radius = arguments_.scoring.place_radius;
    report.notes.push_back(
        "The protocol says which key frames were taken from about one place: which queries could "
        "have been found. " +
        (radius
             ? "The verdicts look at the estimated pose, and call wrong whatever lies more than " +
                   short_text(*radius) + " m from the query's camera (--place-radius)."
             : std::string("The verdicts look at the estimated pose alone, so that a match of "
                           "two views from different sides can be correct.")));
  } else if (arguments_.scoring.different_places) {
    report.notes.push_back(
        "The sequences share no place: every accepted match is wrong, and the figures that need "
        "true places are left out.");
  } else {
    report.notes.push_back(
        "Not every key frame has a true pose: only the figures that need none are drawn.");
  }
}

Report RecognitionPage::report() const {
  const std::vector<QueryOutcome> outcomes = outcomes_of(run_, places());
  const std::string queries = name_of(run_.query_set);
  Report report{loop_gap_ ? "Loops in " + queries : queries + " in " + name_of(run_.map_set)};
  add_facts(report, outcomes);
  std::vector<Figure>& figures = report.figures;
  const auto append = [&](std::vector<Figure> more) {
    std::move(more.begin(), more.end(), std::back_inserter(figures));
  };
  if (places_) {
    figures.push_back(trajectory_figure(*places_, outcomes, loop_gap_.has_value()));
    append(answer_figures(run_, *places_, arguments_.scoring));
  }
  append(matrix_figures(run_, places(), outcomes));
  figures.push_back(verdict_figure(run_));
  std::vector<JudgedError> errors;
  for (std::size_t i = 0; i < run_.records.size(); ++i) {
    if (run_.records[i].error) errors.push_back({*run_.records[i].error, outcomes[i].outcome});
  }
  append(error_figures(errors, arguments_.scoring.limits));
  append(breakdown_figures(outcomes));
  append(match_figures(run_));
  return report;
}

}  // namespace

void add_recognition_report_options(CLI::App& command, RecognitionReportArguments& arguments) {
  add_report_options(command, arguments.files);
  command
      .add_option("--protocol", arguments.protocol,
                  "What a true place is in the report, as in evaluate")
      ->capture_default_str();
  add_output_option(command, "--pairs", arguments.pairs,
                    "CSV to write: every candidate that was tried");
}

KeptCandidates kept_for(const RecognitionReportArguments& arguments) {
  return wanted(arguments.files) || !arguments.pairs.empty() ? KeptCandidates::tried
                                                             : KeptCandidates::best;
}

void write_recognition_report(const RecognitionRun& run, const RecognitionArguments& recognition,
                              const RecognitionReportArguments& arguments,
                              std::optional<double> loop_gap) {
  if (kept_for(arguments) == KeptCandidates::best) return;
  const RecognitionPage page(run, recognition, arguments.protocol, loop_gap);
  if (!arguments.pairs.empty()) write_file(arguments.pairs, to_csv(page.pairs()));
  if (wanted(arguments.files)) write_report(page.report(), arguments.files);
}

}  // namespace program
