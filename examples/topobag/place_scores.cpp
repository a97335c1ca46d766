// SPDX-License-Identifier: MIT
#include "place_scores.hpp"

#include <cstddef>

#include <Eigen/Core>

#include <topobag/recognition/place_score.hpp>

#include "similarity_scores.hpp"

namespace program {

topobag::ScoreMatrix place_scores(const RecognitionRun& run) {
  topobag::ScoreMatrix scores = score_by_bag(run.queries, run.map).scores;
  for (Eigen::Index i = 0; i < scores.size(); ++i) {
    topobag::CandidateReport unverified;
    unverified.similarity = scores.data()[i];
    scores.data()[i] = topobag::place_score(unverified);
  }
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    for (const TriedCandidate& tried : run.records[i].tried) {
      scores(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(tried.candidate)) =
          tried.place_score;
    }
  }
  return scores;
}

}  // namespace program
