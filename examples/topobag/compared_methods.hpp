// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <topobag/evaluation/labelled_scores.hpp>
#include <topobag/evaluation/place_truth.hpp>

#include "comparison.hpp"
#include "recognition_run.hpp"
#include "similarity_scores.hpp"

// The methods that `compare` holds against each other on the pairs of one run.
namespace program {

/// The library at its defaults.
/// @param run  looked up and scored
ComparedMethod default_method(const RecognitionRun& run, const topobag::ScoreMatrix& scores,
                              const topobag::PlaceTruth& truth);

/// The paper's whole pipeline: only what hardly moves, single frames, Delaunay in the image,
/// eq. 12.
/// @param static_frames  key frames of that kind
ComparedMethod paper_method(const RecognitionRun& static_frames, const topobag::PlaceTruth& truth);

/// A method of the user's own, by its scores of the key frames of query and map, in the file
/// `path`; its best answers are verified in `run`.
ComparedMethod own_method(RecognitionRun& run, const std::string& path, const std::string& name,
                          const topobag::PlaceTruth& truth, const Comparison& comparison);

/// A similarity of the library; so many of its best answers to a query are verified in `run`.
ComparedMethod similarity_method(RecognitionRun& run, SimilarityScores similarity,
                                 const topobag::PlaceTruth& truth, std::size_t count);

}  // namespace program
