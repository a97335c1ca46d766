// SPDX-License-Identifier: MIT
#include "compared_methods.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "look_up.hpp"
#include "pair_scores.hpp"

namespace program {
namespace {

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

/// What the library's verification makes of a method's best answers.
RunSummary verified(RecognitionRun& run, const PairScores& scores, const topobag::PlaceTruth& truth,
                    std::size_t count) {
  verify(run, best_answers(scores, truth, count));
  score(run, Scoring{});
  return summarize(run);
}

}  // namespace

ComparedMethod default_method(const RecognitionRun& run, const topobag::ScoreMatrix& scores,
                              const topobag::PlaceTruth& truth) {
  ComparedMethod method{
      "default", "the library: retrieval, all verified, ranked by verification and viewpoint"};
  method.labelled = topobag::label_scores(scores, truth);
  method.pair_us = verification_us(run);
  method.poses = summarize(run);
  return method;
}

ComparedMethod paper_method(const RecognitionRun& static_frames, const topobag::PlaceTruth& truth) {
  const SimilarityScores scores = score_padded_cosine(static_frames.queries, static_frames.map);
  ComparedMethod method{"paper's whole pipeline",
                        "static objects, single frames, image Delaunay, eq. 12; no pose"};
  method.labelled = topobag::label_scores(scores.scores, truth);
  method.pair_us = scores.pair_us;
  return method;
}

ComparedMethod own_method(RecognitionRun& run, const std::string& path, const std::string& name,
                          const topobag::PlaceTruth& truth, const Comparison& comparison) {
  const PairScores scores = read_pair_scores(path, false);
  ComparedMethod method{name, "scores of " + path, label_scores(scores, truth, path)};
  method.meaning += unscored_text(method.labelled, comparison.true_pairs + comparison.false_pairs);
  method.poses = verified(run, scores, truth, comparison.verified);
  return method;
}

ComparedMethod similarity_method(RecognitionRun& run, SimilarityScores similarity,
                                 const topobag::PlaceTruth& truth, std::size_t count) {
  ComparedMethod method{std::move(similarity.name), std::move(similarity.meaning),
                        topobag::label_scores(similarity.scores, truth), similarity.pair_us};
  method.poses = verified(run, std::move(similarity.scores), truth, count);
  return method;
}

}  // namespace program
