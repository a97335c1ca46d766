// SPDX-License-Identifier: MIT
#include "pair_figures.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "html_text.hpp"
#include "run_outcomes.hpp"
#include "score_figures.hpp"
#include "score_image.hpp"

namespace program {
namespace {

const std::size_t most_pairs_in_page = 20000;

std::string pair_hint(const TriedCandidate& tried, std::size_t query, const KnownPlaces* places) {
  std::string text = to_string(tried.verdict);
  if (places == nullptr) return text;
  const Eigen::Isometry3d pose = places->truth.T_candidate_query(query, tried.candidate);
  return text + "; cameras " + fixed_text(pose.translation().norm(), 2) + " m and " +
         fixed_text(topobag::rotation_angle_deg(pose.linear()), 0) + "° apart";
}

}  // namespace

DataTable pair_table(const RecognitionRun& run, const KnownPlaces* places) {
  DataTable table{{"query", "candidate", "query_idx", "candidate_idx", "similarity", "score",
                   "objects", "verdict", "relation", "distance_m", "angle_deg"},
                  {}};
  const std::array<const char*, 4> relations{"true", "false", "ignored", "excluded"};
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    for (const TriedCandidate& tried : run.records[i].tried) {
      const std::size_t id = tried.candidate;
      Json row = Json::array({i, id, run.queries[i].idx, run.map[id].idx, tried.similarity});
      row.push_back(or_null(tried.score));
      row.push_back(tried.objects);
      row.push_back(to_string(tried.verdict));
      if (places != nullptr) {
        const Eigen::Isometry3d pose = places->truth.T_candidate_query(i, id);
        row.push_back(relations[static_cast<std::size_t>(places->truth.relation(i, id))]);
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

std::vector<Figure> answer_figures(const RecognitionRun& run, const KnownPlaces& places,
                                   const Scoring& scoring) {
  std::vector<topobag::ScoredPair> similarities;
  std::vector<topobag::ScoredPair> place_scores;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    for (const TriedCandidate& tried : run.records[i].tried) {
      topobag::ScoredPair pair{static_cast<std::uint32_t>(i),
                               static_cast<std::uint32_t>(tried.candidate), tried.similarity};
      similarities.push_back(pair);
      pair.score = tried.place_score;
      place_scores.push_back(pair);
    }
  }
  const NamedScores answers{"match score", answer_scores(run, places, scoring), 1.0, "answers"};
  const std::vector<NamedScores> rankings{
      {"place score", topobag::label_scores(std::move(place_scores), places.truth)},
      {"similarity", topobag::label_scores(std::move(similarities), places.truth)}};
  return {precision_recall_figure(
              {answers},
              "Each query's best match, ranked by the score that decides; true when its pose is "
              "not wrong. Of all that have a true place or a true answer; a match that was refused "
              "because another fits as well is no answer, whatever its score."),
          score_histogram_figure("match-scores", answers), recall_at_k_figure(rankings),
          score_histogram_figure("similarities", rankings[1])};
}

std::vector<Figure> matrix_figures(const RecognitionRun& run, const KnownPlaces* places,
                                   const std::vector<QueryOutcome>& outcomes) {
  const std::size_t rows = run.queries.size();
  const std::size_t columns = run.map.size();
  const bool with_hints = rows * columns <= most_pairs_in_page;
  ScoreImage similarities(rows, columns);
  ScoreImage scores(rows, columns);
  std::size_t pairs_tried = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (const TriedCandidate& tried : run.records[i].tried) {
      const std::size_t id = tried.candidate;
      ++pairs_tried;
      similarities.add(i, id, tried.similarity);
      if (tried.score) scores.add(i, id, *tried.score);
      if (!with_hints) continue;
      const std::string hint = pair_hint(tried, i, places);
      similarities.hint(i, id, hint);
      scores.hint(i, id, hint);
    }
    for (ScoreImage* const image : {&similarities, &scores}) {
      for (std::size_t k = 0; places != nullptr && k < columns; ++k) {
        if (places->truth.relation(i, k) == topobag::PairRelation::positive) image->mark_true(i, k);
      }
      if (outcomes[i].answer) image->mark_answer(i, *outcomes[i].answer, outcomes[i].outcome);
    }
  }
  ScoreImage::Names names{"similarity-matrix", "Similarity of every pair", "similarity"};
  for (const Keyframe& keyframe : run.queries) names.rows.push_back(keyframe.idx);
  for (const Keyframe& keyframe : run.map) names.columns.push_back(keyframe.idx);
  std::vector<Figure> figures{similarities.figure(names)};
  if (pairs_tried <= most_pairs_in_page) figures.back().table = pair_table(run, places);
  names.id = "score-matrix";
  names.title = "Match score of every pair";
  names.score = "match score";
  figures.push_back(scores.figure(names));
  return figures;
}

Figure verdict_figure(const RecognitionRun& run) {
  Figure figure{"verdicts", "How far the best candidate of each query came", "", ""};
  const std::array<const char*, 6> names{"no agreement", "chance",        "place only",
                                         "ambiguous",    "another place", "accepted"};
  const std::size_t accepted_bar = names.size() - 1;
  std::array<std::size_t, 6> counts{};
  std::size_t without = 0;
  for (const QueryRecord& record : run.records) {
    if (!record.is_query()) {
      ++without;
      continue;
    }
    const auto& best = record.best();
    const bool accepted = best.verdict == topobag::Verdict::accepted;
    ++counts[accepted ? accepted_bar : static_cast<std::size_t>(best.verdict)];
  }
  PlotAxis x{"stage", 0.0, static_cast<double>(names.size()), {}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    x.ticks.push_back({static_cast<double>(i) + 0.5, names[i]});
  }
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  SvgPlot plot(std::move(x), axis_from_zero("queries", static_cast<double>(most)));
  figure.table.columns = {"verdict", "queries"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto at = static_cast<double>(i);
    plot.bar({at + 0.12, 0.0}, {at + 0.88, static_cast<double>(counts[i])},
             i == accepted_bar ? "correct" : "nothing",
             std::to_string(counts[i]) + " queries: " + names[i]);
    figure.table.rows.push_back(Json::array({names[i], counts[i]}));
    figure.caption += std::string(names[i]) + ' ' + std::to_string(counts[i]) + ", ";
  }
  figure.caption += "and " + std::to_string(without) +
                    " key frames without a usable graph or without a candidate.";
  figure.drawing = plot.svg(figure.title + ". " + figure.caption);
  return figure;
}

}  // namespace program
