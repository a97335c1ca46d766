// SPDX-License-Identifier: MIT
#include "run_outcomes.hpp"

#include <algorithm>
#include <cstdint>

namespace program {

std::vector<QueryOutcome> outcomes_of(const RecognitionRun& run, const KnownPlaces* places) {
  std::vector<QueryOutcome> outcomes;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const QueryRecord& record = run.records[i];
    QueryOutcome query;
    query.objects = run.queries[i].graph.size();
    if (places != nullptr) query.place = nearest_true_place(*places, i);
    if (const auto& match = record.recognition.accepted) {
      query.answer = topobag::value(match->id);
      query.score = match->score();
      query.outcome = record.verdict ? outcome_of(*record.verdict) : Outcome::unscored;
    } else {
      query.outcome = query.place ? Outcome::missed : Outcome::nothing;
    }
    outcomes.push_back(query);
  }
  return outcomes;
}

topobag::LabelledScores answer_scores(const RecognitionRun& run, const KnownPlaces& places,
                                      const Scoring& scoring) {
  using topobag::Verdict;
  topobag::LabelledScores answers;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const QueryRecord& record = run.records[i];
    answers.totals.push_back({nearest_true_place(places, i) ? std::size_t{1} : 0, 0});
    if (!record.is_query()) continue;
    const topobag::CandidateReport& best = record.best();
    if (best.verdict != Verdict::accepted && best.verdict != Verdict::insignificant) continue;
    const auto verdict = judge_match(run, i, best, scoring).verdict;
    const bool is_true = verdict && *verdict != topobag::PoseVerdict::wrong;
    if (is_true) answers.totals.back().positives = 1;
    answers.scores.push_back({best.score(), static_cast<std::uint32_t>(i), is_true});
  }
  std::stable_sort(answers.scores.begin(), answers.scores.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  return answers;
}

}  // namespace program
