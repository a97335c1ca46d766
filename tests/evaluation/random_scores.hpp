// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include <topobag/evaluation/labelled_scores.hpp>

#include "evaluation/random_poses.hpp"

namespace topobag_tests {

/// A small retrieval problem with many ties: key frames on a line, scores that are small integers.
struct ScoredPlaces {
  topobag::Trajectory places;
  topobag::PlaceProtocol protocol;
  topobag::ScoreMatrix scores;

  topobag::PlaceTruth truth() const { return {protocol, places}; }
  topobag::LabelledScores labelled() const { return topobag::label_scores(scores, truth()); }
};

inline ScoredPlaces random_scored_places(std::mt19937& random) {
  const auto draw = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  ScoredPlaces problem;
  const int n = draw(2, 8);
  for (int i = 0; i < n; ++i) {
    problem.places.push_back({double(i), planar_pose(draw(0, 12), 0, 0)});
  }
  problem.protocol.distance_m = draw(0, 3);
  if (draw(0, 1) == 1) problem.protocol.negative_distance_m = *problem.protocol.distance_m + 2.0;
  problem.protocol.exclude_frames = static_cast<std::size_t>(draw(0, 3));
  problem.protocol.past_only = draw(0, 3) == 0;
  const int levels = draw(1, 30);
  problem.scores = topobag::ScoreMatrix::NullaryExpr(n, n, [&] { return draw(1, levels) / 8.0; });
  return problem;
}

}  // namespace topobag_tests
