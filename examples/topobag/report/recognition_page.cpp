// SPDX-License-Identifier: MIT
#include "recognition_page.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <topobag/evaluation/protocol_text.hpp>

#include "csv_reader.hpp"
#include "html_text.hpp"
#include "match_figures.hpp"
#include "outcome_figures.hpp"
#include "query_outcome.hpp"
#include "score_figures.hpp"
#include "score_image.hpp"
#include "trajectory_figure.hpp"

namespace program {
namespace {

const std::size_t most_pairs_in_page = 20000;

std::optional<topobag::Trajectory> trajectory_of(const std::vector<Keyframe>& keyframes) {
  topobag::Trajectory trajectory;
  for (const Keyframe& keyframe : keyframes) {
    if (!keyframe.T_world_camera) return std::nullopt;
    trajectory.push_back({keyframe.timestamp, *keyframe.T_world_camera});
  }
  return trajectory;
}

/// Two views that share half of what they see, up to the depth of a room, are of one place.
topobag::PlaceProtocol protocol_of(const std::string& text, const topobag::PinholeCamera<>& camera,
                                   std::optional<double> loop_gap) {
  if (!text.empty()) return topobag::parse_protocol(text);
  topobag::PlaceProtocol protocol;
  protocol.covisibility = 0.5;
  protocol.frustum = topobag::DepthFrustum{camera, 0.4, 4.0};
  if (loop_gap) {
    protocol.exclude_seconds = *loop_gap;
    protocol.past_only = true;
  }
  return protocol;
}

/// Makes the report of one run.
class RecognitionPage {
 public:
  RecognitionPage(const RecognitionRun& run, const RecognitionArguments& arguments,
                  const std::string& protocol, std::optional<double> loop_gap)
      : run_(run), arguments_(arguments), loop_gap_(loop_gap) {
    auto queries = trajectory_of(run.queries);
    auto map = trajectory_of(run.map);
    if (!queries || !map || arguments.scoring.different_places) return;
    const topobag::PlaceProtocol declared = protocol_of(
        protocol, with_size(arguments.keyframes.camera, arguments.image_size), loop_gap);
    const topobag::PlaceTruth truth = loop_gap ? topobag::PlaceTruth(declared, *queries)
                                               : topobag::PlaceTruth(declared, *queries, *map);
    places_ = KnownPlaces{*std::move(queries), *std::move(map), truth};
  }

  Report report() const;
  DataTable pairs() const;

 private:
  std::vector<QueryOutcome> outcomes() const;
  void add_facts(Report& report, const std::vector<QueryOutcome>& outcomes) const;
  void add_score_figures(std::vector<Figure>& figures) const;
  void add_matrices(std::vector<Figure>& figures, const std::vector<QueryOutcome>& outcomes) const;
  Figure verdict_figure() const;
  std::string pair_hint(const topobag::CandidateReport& candidate, std::size_t query) const;

  const RecognitionRun& run_;
  const RecognitionArguments& arguments_;
  std::optional<double> loop_gap_;
  std::optional<KnownPlaces> places_;
};

std::vector<QueryOutcome> RecognitionPage::outcomes() const {
  std::vector<QueryOutcome> outcomes;
  for (std::size_t i = 0; i < run_.look_ups.size(); ++i) {
    const LookUp& look_up = run_.look_ups[i];
    QueryOutcome query;
    query.objects = run_.queries[i].graph.size();
    if (places_) query.place = nearest_true_place(*places_, i);
    if (const auto& match = look_up.recognition.accepted) {
      query.answer = topobag::value(match->id);
      query.score = match->pose->score();
      query.outcome = look_up.verdict ? outcome_of(*look_up.verdict) : Outcome::unscored;
    } else {
      query.outcome = query.place ? Outcome::missed : Outcome::nothing;
    }
    outcomes.push_back(query);
  }
  return outcomes;
}

DataTable RecognitionPage::pairs() const {
  DataTable table{{"query", "candidate", "query_idx", "candidate_idx", "similarity", "score",
                   "objects", "verdict", "relation", "distance_m", "angle_deg"},
                  {}};
  const std::array<const char*, 4> relations{"true", "false", "ignored", "excluded"};
  for (std::size_t i = 0; i < run_.look_ups.size(); ++i) {
    for (const topobag::CandidateReport& candidate : run_.look_ups[i].recognition.candidates) {
      const std::size_t id = topobag::value(candidate.id);
      Json row = Json::array({i, id, run_.queries[i].idx, run_.map[id].idx, candidate.similarity});
      row.push_back(candidate.pose ? Json(candidate.pose->score()) : Json());
      row.push_back(candidate.pose ? candidate.pose->inliers.size() : 0);
      row.push_back(to_string(candidate.verdict));
      if (places_) {
        const Eigen::Isometry3d pose = places_->truth.T_candidate_query(i, id);
        row.push_back(relations[static_cast<std::size_t>(places_->truth.relation(i, id))]);
        row.push_back(pose.translation().norm());
        row.push_back(topobag::rotation_angle_deg(pose.linear()));
      } else {
        for (int k = 0; k < 3; ++k) row.push_back(nullptr);
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

void RecognitionPage::add_facts(Report& report, const std::vector<QueryOutcome>& outcomes) const {
  const RunSummary summary = summarize(run_);
  const KeyframeOptions& keyframes = arguments_.keyframes;
  const topobag::PoseLimits& limits = arguments_.scoring.limits;
  const auto count = [](std::size_t number) { return std::to_string(number); };
  auto& facts = report.facts;
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
  facts.emplace_back("Accepted", count(summary.accepted) + " of " + count(summary.queries) +
                                     " queries with a usable graph and a candidate");
  facts.emplace_back("Verdicts", count(summary.correct) + " correct, " + count(summary.imprecise) +
                                     " imprecise, " + count(summary.wrong) + " wrong, " +
                                     count(summary.unscored) + " not scored");
  if (summary.median_translation_error_m) {
    facts.emplace_back("Median error of the accepted",
                       fixed_text(*summary.median_translation_error_m, 3) + " m, " +
                           fixed_text(*summary.median_rotation_error_deg, 1) + "°");
  }
  facts.emplace_back("Correct is", "up to " + short_text(limits.correct_translation_m) + " m and " +
                                       short_text(limits.correct_rotation_deg) +
                                       "°; wrong beyond " + short_text(limits.wrong_translation_m) +
                                       " m or " + short_text(limits.wrong_rotation_deg) + "°");
  if (places_) {
    const auto true_places =
        std::count_if(outcomes.begin(), outcomes.end(),
                      [](const QueryOutcome& q) { return q.place.has_value(); });
    facts.emplace_back("Queries with a true place", std::to_string(true_places));
    facts.emplace_back("Protocol: what a true place is",
                       topobag::to_string(places_->truth.protocol()));
    report.notes.push_back(
        "The protocol says which pairs show one place. The verdicts look at the estimated pose "
        "alone, so that a match of two views that hardly overlap can be correct.");
  } else if (arguments_.scoring.different_places) {
    report.notes.push_back(
        "The sequences share no place: every accepted match is wrong, and the figures that need "
        "true places are left out.");
  } else {
    report.notes.push_back(
        "Not every key frame has a true pose: only the figures that need none are drawn.");
  }
}

void RecognitionPage::add_score_figures(std::vector<Figure>& figures) const {
  std::vector<topobag::ScoredPair> similarities;
  std::vector<topobag::ScoredPair> scores;
  for (std::size_t i = 0; i < run_.look_ups.size(); ++i) {
    for (const topobag::CandidateReport& candidate : run_.look_ups[i].recognition.candidates) {
      topobag::ScoredPair pair{static_cast<std::uint32_t>(i),
                               static_cast<std::uint32_t>(topobag::value(candidate.id)),
                               candidate.similarity};
      similarities.push_back(pair);
      if (!candidate.pose) continue;
      pair.score = candidate.pose->score();
      scores.push_back(pair);
    }
  }
  const std::vector<NamedScores> methods{
      {"match score", topobag::label_scores(std::move(scores), places_->truth)},
      {"similarity", topobag::label_scores(std::move(similarities), places_->truth)}};
  figures.push_back(precision_recall_figure(methods));
  figures.push_back(recall_at_k_figure(methods));
  figures.push_back(score_histogram_figure("match-scores", methods[0]));
  figures.push_back(score_histogram_figure("similarities", methods[1]));
}

std::string RecognitionPage::pair_hint(const topobag::CandidateReport& candidate,
                                       std::size_t query) const {
  std::string text = to_string(candidate.verdict);
  if (!places_) return text;
  const Eigen::Isometry3d pose =
      places_->truth.T_candidate_query(query, topobag::value(candidate.id));
  return text + "; cameras " + fixed_text(pose.translation().norm(), 2) + " m and " +
         fixed_text(topobag::rotation_angle_deg(pose.linear()), 0) + "° apart";
}

void RecognitionPage::add_matrices(std::vector<Figure>& figures,
                                   const std::vector<QueryOutcome>& outcomes) const {
  const std::size_t rows = run_.queries.size();
  const std::size_t columns = run_.map.size();
  const bool with_hints = rows * columns <= most_pairs_in_page;
  ScoreImage similarities(rows, columns);
  ScoreImage scores(rows, columns);
  std::size_t pairs_tried = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (const topobag::CandidateReport& candidate : run_.look_ups[i].recognition.candidates) {
      const std::size_t id = topobag::value(candidate.id);
      ++pairs_tried;
      similarities.add(i, id, candidate.similarity);
      if (candidate.pose) scores.add(i, id, candidate.pose->score());
      if (!with_hints) continue;
      const std::string hint = pair_hint(candidate, i);
      similarities.hint(i, id, hint);
      scores.hint(i, id, hint);
    }
    for (ScoreImage* const image : {&similarities, &scores}) {
      for (std::size_t k = 0; places_ && k < columns; ++k) {
        if (places_->truth.relation(i, k) == topobag::PairRelation::positive)
          image->mark_true(i, k);
      }
      if (outcomes[i].answer) image->mark_answer(i, *outcomes[i].answer, outcomes[i].outcome);
    }
  }
  ScoreImage::Names names{"similarity-matrix", "Similarity of every pair", "similarity"};
  for (const Keyframe& keyframe : run_.queries) names.rows.push_back(keyframe.idx);
  for (const Keyframe& keyframe : run_.map) names.columns.push_back(keyframe.idx);
  figures.push_back(similarities.figure(names));
  if (pairs_tried <= most_pairs_in_page) figures.back().table = pairs();
  names.id = "score-matrix";
  names.title = "Match score of every pair";
  names.score = "match score";
  figures.push_back(scores.figure(names));
}

Figure RecognitionPage::verdict_figure() const {
  Figure figure{"verdicts", "How far the best candidate of each query came", "", ""};
  const std::array<const char*, 5> names{"no agreement", "degenerate", "chance", "ambiguous",
                                         "accepted"};
  std::array<std::size_t, 5> counts{};
  std::size_t without = 0;
  for (const LookUp& look_up : run_.look_ups) {
    if (!look_up.is_query()) {
      ++without;
      continue;
    }
    const auto& best = look_up.recognition.accepted ? *look_up.recognition.accepted
                                                    : look_up.recognition.candidates.front();
    const bool accepted = best.verdict == topobag::Verdict::accepted;
    ++counts[accepted ? 4 : static_cast<std::size_t>(best.verdict)];
  }
  PlotAxis x{"stage", 0.0, 5.0, {}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    x.ticks.push_back({static_cast<double>(i) + 0.5, names[i]});
  }
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  SvgPlot plot(std::move(x), axis_from_zero("queries", static_cast<double>(most)));
  figure.table.columns = {"verdict", "queries"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto at = static_cast<double>(i);
    plot.bar({at + 0.12, 0.0}, {at + 0.88, static_cast<double>(counts[i])},
             i == 4 ? "correct" : "nothing", std::to_string(counts[i]) + " queries: " + names[i]);
    figure.table.rows.push_back(Json::array({names[i], counts[i]}));
    figure.caption += std::string(names[i]) + ' ' + std::to_string(counts[i]) + ", ";
  }
  figure.caption += "and " + std::to_string(without) +
                    " key frames without a usable graph or without a candidate.";
  figure.drawing = plot.svg(figure.title + ". " + figure.caption);
  return figure;
}

Report RecognitionPage::report() const {
  const std::vector<QueryOutcome> outcomes = this->outcomes();
  const std::string queries = name_of(run_.query_set);
  Report report{loop_gap_ ? "Loops in " + queries : queries + " in " + name_of(run_.map_set)};
  add_facts(report, outcomes);
  std::vector<Figure>& figures = report.figures;
  const auto append = [&](std::vector<Figure> more) {
    std::move(more.begin(), more.end(), std::back_inserter(figures));
  };
  if (places_) {
    figures.push_back(trajectory_figure(*places_, outcomes, loop_gap_.has_value()));
    add_score_figures(figures);
  }
  add_matrices(figures, outcomes);
  figures.push_back(verdict_figure());
  std::vector<JudgedError> errors;
  for (std::size_t i = 0; i < run_.look_ups.size(); ++i) {
    if (run_.look_ups[i].error) errors.push_back({*run_.look_ups[i].error, outcomes[i].outcome});
  }
  append(error_figures(errors, arguments_.scoring.limits));
  append(breakdown_figures(outcomes));
  append(match_figures(run_));
  return report;
}

}  // namespace

void add_recognition_report_options(CLI::App& command, RecognitionReportArguments& arguments) {
  add_report_options(command, arguments.files);
  command.add_option("--protocol", arguments.protocol,
                     "What a true place is in the report, as in evaluate [views that overlap by "
                     "0.5 from 0.4 to 4 m]");
  command.add_option("--pairs", arguments.pairs, "CSV to write: every candidate that was tried");
}

void write_recognition_report(const RecognitionRun& run, const RecognitionArguments& recognition,
                              const RecognitionReportArguments& arguments,
                              std::optional<double> loop_gap) {
  if (!wanted(arguments.files) && arguments.pairs.empty()) return;
  const RecognitionPage page(run, recognition, arguments.protocol, loop_gap);
  if (!arguments.pairs.empty()) write_file(arguments.pairs, to_csv(page.pairs()));
  if (wanted(arguments.files)) write_report(page.report(), arguments.files);
}

}  // namespace program
