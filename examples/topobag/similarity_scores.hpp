// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <topobag/evaluation/labelled_scores.hpp>

#include "keyframe_graphs.hpp"

namespace program {

/// What one similarity says of every pair of key frames.
struct SimilarityScores {
  std::string name;
  std::string meaning;
  topobag::ScoreMatrix scores;  ///< a row per query, a column per key frame of the map
  double pair_us = 0.0;  ///< time of all, descriptors included, over the number of pairs, µs
};

/// Every similarity of the library, in the order of its headers. Class weights are learnt from the
/// map alone.
std::vector<SimilarityScores> score_similarities(const std::vector<Keyframe>& queries,
                                                 const std::vector<Keyframe>& map);

/// The similarity by which the bag retrieves.
SimilarityScores score_by_bag(const std::vector<Keyframe>& queries,
                              const std::vector<Keyframe>& map);

/// The paper's similarity, eq. 12, in the detector's order.
SimilarityScores score_padded_cosine(const std::vector<Keyframe>& queries,
                                     const std::vector<Keyframe>& map);

}  // namespace program
