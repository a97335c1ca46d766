// SPDX-License-Identifier: MIT
#include "retrieval_page.hpp"

#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include <topobag/evaluation/precision_recall.hpp>
#include <topobag/evaluation/protocol_text.hpp>

#include "html_text.hpp"
#include "outcome_figures.hpp"
#include "score_image.hpp"
#include "trajectory_figure.hpp"

namespace program {
namespace {

using topobag::PairRelation;

/// The relation of every pair, asked for once: an overlap of views is dear.
class Relations {
 public:
  explicit Relations(const topobag::PlaceTruth& truth) : columns_(truth.num_candidates()) {
    relations_.reserve(truth.num_queries() * columns_);
    for (std::size_t i = 0; i < truth.num_queries(); ++i) {
      for (std::size_t k = 0; k < columns_; ++k) relations_.push_back(truth.relation(i, k));
    }
  }
  PairRelation operator()(std::size_t query, std::size_t candidate) const {
    return relations_[query * columns_ + candidate];
  }

 private:
  std::size_t columns_;
  std::vector<PairRelation> relations_;
};

/// Where F1 of the queries' best answers is best; nothing is accepted without a true answer.
double best_f1_threshold(const topobag::LabelledScores& labelled) {
  const auto metrics = topobag::retrieval_metrics(topobag::single_best(labelled));
  return metrics && metrics->f1_max > 0.0 ? metrics->f1_max_threshold
                                          : std::numeric_limits<double>::infinity();
}

std::vector<QueryOutcome> outcomes_of(const KnownPlaces& places, const RetrievalRun& run,
                                      const Relations& relations, double accept) {
  std::vector<QueryOutcome> outcomes(places.queries.size());
  for_each_score(run.scores, [&](std::size_t query, std::size_t candidate, double score) {
    const PairRelation relation = relations(query, candidate);
    if (relation == PairRelation::ignored || relation == PairRelation::excluded) return;
    QueryOutcome& outcome = outcomes[query];
    if (score < accept) return;
    if (outcome.answer && score < outcome.score) return;
    if (outcome.answer && score == outcome.score && *outcome.answer < candidate) return;
    outcome.answer = candidate;
    outcome.score = score;
    outcome.outcome = relation == PairRelation::positive ? Outcome::correct : Outcome::wrong;
  });
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    outcomes[i].place = nearest_true_place(places, i);
    if (!outcomes[i].answer && outcomes[i].place) outcomes[i].outcome = Outcome::missed;
  }
  return outcomes;
}

Figure matrix_of(const RetrievalRun& run, const Relations& relations,
                 const std::vector<QueryOutcome>& outcomes, std::size_t candidates) {
  ScoreImage image(outcomes.size(), candidates);
  for_each_score(run.scores, [&](std::size_t query, std::size_t candidate, double score) {
    if (relations(query, candidate) != PairRelation::excluded) image.add(query, candidate, score);
  });
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    for (std::size_t k = 0; k < candidates; ++k) {
      if (relations(i, k) == PairRelation::positive) image.mark_true(i, k);
    }
    if (outcomes[i].answer) image.mark_answer(i, *outcomes[i].answer, outcomes[i].outcome);
  }
  ScoreImage::Names names{"score-matrix", "Score of every pair", "score"};
  names.rows.resize(outcomes.size());
  names.columns.resize(candidates);
  std::iota(names.rows.begin(), names.rows.end(), 0);
  std::iota(names.columns.begin(), names.columns.end(), 0);
  names.sign = run.methods.front().sign;
  return image.figure(names);
}

std::vector<JudgedError> errors_of(const KnownPlaces& places, const RetrievalRun& run) {
  std::vector<JudgedError> errors;
  const auto* const list = std::get_if<topobag::ScoreList>(&run.scores);
  if (list == nullptr) return errors;
  const double accept = run.accept.value_or(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < list->T_candidate_query.size(); ++i) {
    const topobag::ScoredPair& pair = list->pairs[i];
    if (pair.score < accept) continue;
    const topobag::PoseError error = topobag::pose_error(
        places.truth.T_candidate_query(pair.query, pair.candidate), list->T_candidate_query[i]);
    errors.push_back({error, outcome_of(topobag::judge(error, run.limits))});
  }
  return errors;
}

void add_facts(Report& report, const KnownPlaces& places, const RetrievalRun& run, double accept) {
  const NamedScores& method = run.methods.front();
  const topobag::PairTotals totals = topobag::sum_of_totals(method.labelled);
  auto& facts = report.facts;
  facts.emplace_back("Scores", method.name + (method.sign < 0.0 ? ", lower is better" : ""));
  std::string others;
  for (std::size_t i = 1; i < run.methods.size(); ++i) {
    others += (i > 1 ? ", " : "") + run.methods[i].name;
  }
  if (!others.empty()) facts.emplace_back("Held against", others);
  facts.emplace_back("Protocol: what a true place is", topobag::to_string(places.truth.protocol()));
  facts.emplace_back("Queries × candidates", std::to_string(places.queries.size()) + " × " +
                                                 std::to_string(places.map.size()));
  facts.emplace_back("Evaluated pairs", std::to_string(totals.positives) + " true, " +
                                            std::to_string(totals.negatives) + " false");
  if (!run.outcomes.empty()) {
    facts.emplace_back("Accepted answers", "those of the library's decision");
    facts.emplace_back("Correct is", "up to " + short_text(run.limits.correct_translation_m) +
                                         " m and " + short_text(run.limits.correct_rotation_deg) +
                                         "° of the true pose");
    return;
  }
  facts.emplace_back("Accepted answers",
                     std::isfinite(accept)
                         ? "each query's best from score " + short_text(method.sign * accept) +
                               (run.accept ? " on, as asked for" : " on, where their F1 is best")
                         : "none: no query's best answer is true, so no threshold is best");
  facts.emplace_back("Correct is", "a true pair by the protocol");
}

void add_notes(Report& report, const KnownPlaces& places, const RetrievalRun& run) {
  if (run.outcomes.empty()) {
    report.notes.push_back(
        "Scores say nothing of the graphs behind them: no breakdown by the number "
        "of objects and no drawn matches.");
  }
  if (!places.frustum) {
    report.notes.push_back(
        "The protocol gives no frustum, so the overlap of views is not known: no breakdown by it.");
  }
}

}  // namespace

Report retrieval_report(const KnownPlaces& places, const RetrievalRun& run) {
  const Relations relations(places.truth);
  const NamedScores& method = run.methods.front();
  const double accept = run.accept.value_or(best_f1_threshold(method.labelled));
  const std::vector<QueryOutcome> outcomes =
      run.outcomes.empty() ? outcomes_of(places, run, relations, accept) : run.outcomes;

  Report report{"Place recognition by " + std::filesystem::path(method.name).filename().string()};
  add_facts(report, places, run, accept);
  add_notes(report, places, run);
  std::vector<Figure>& figures = report.figures;
  const auto append = [&](std::vector<Figure> more) {
    std::move(more.begin(), more.end(), std::back_inserter(figures));
  };
  std::vector<NamedScores> curves;
  for (const NamedScores& each : run.methods) {
    curves.push_back({each.name, topobag::single_best(each.labelled), each.sign});
  }
  if (curves.size() == 1) {
    curves.front().name = "best answer of each query";
    curves.push_back({"all pairs", method.labelled, method.sign});
  }
  figures.push_back(trajectory_figure(places, outcomes, run.one_trajectory));
  figures.push_back(precision_recall_figure(
      curves,
      "Each query's best answer, ranked by its score; true is a true pair by the protocol. A match "
      "that is right but no true pair, such as one from another side, counts as false."));
  figures.push_back(recall_at_k_figure(run.methods));
  figures.push_back(score_histogram_figure("scores", {"score", method.labelled, method.sign}));
  figures.push_back(matrix_of(run, relations, outcomes, places.map.size()));
  append(error_figures(errors_of(places, run), run.limits));
  append(breakdown_figures(outcomes));
  return report;
}

}  // namespace program
