// SPDX-License-Identifier: MIT
#include "pair_scores.hpp"

#include <filesystem>
#include <fstream>

#include <topobag/evaluation/npy_matrix.hpp>
#include <topobag/evaluation/protocol_text.hpp>

#include "input_error.hpp"
#include "path_kind.hpp"

namespace program {
namespace {

bool is_npy(const std::string& path) {
  std::string beginning(6, '\0');
  std::ifstream(path, std::ios::binary).read(beginning.data(), 6);
  return beginning == "\x93NUMPY";
}

}  // namespace

PairScores read_pair_scores(const std::string& path, bool lower_is_better) {
  if (std::filesystem::is_directory(path)) {
    throw InputError(path, "it is a folder; name a file in it");
  }
  const PathKind kind = path_kind(path);
  if (kind == PathKind::snapshot || kind == PathKind::sqlite_map) {
    throw InputError(path,
                     "it is a saved map; scores are a matrix (.npy or CSV) or a list (CSV with the "
                     "header query,candidate,score)");
  }
  PairScores scores;
  if (is_npy(path)) {
    scores = topobag::read_npy(path);
  } else {
    scores = topobag::read_score_csv(path);
  }
  const auto* const list = std::get_if<topobag::ScoreList>(&scores);
  if (list != nullptr && list->pairs.empty()) {
    throw InputError(path, "there is no score in the file");
  }
  if (!lower_is_better) return scores;
  if (auto* const matrix = std::get_if<topobag::ScoreMatrix>(&scores)) {
    *matrix = -*matrix;
  } else {
    for (auto& pair : std::get<topobag::ScoreList>(scores).pairs) pair.score = -pair.score;
  }
  return scores;
}

topobag::LabelledScores label_scores(const PairScores& scores, const topobag::PlaceTruth& truth,
                                     const std::string& path) {
  topobag::LabelledScores labelled;
  try {
    const auto* const matrix = std::get_if<topobag::ScoreMatrix>(&scores);
    labelled = matrix ? topobag::label_scores(*matrix, truth)
                      : topobag::label_scores(std::get<topobag::ScoreList>(scores).pairs, truth);
  } catch (const topobag::Error& error) {
    throw InputError(path, error.what());
  }
  if (!labelled.scores.empty()) return labelled;
  throw InputError(path, "none of its scores is of a pair that the protocol " +
                             topobag::to_string(truth.protocol()) + " calls true or false");
}

std::string unscored_text(const topobag::LabelledScores& labelled, std::size_t pairs) {
  const std::size_t scored = labelled.scores.size();
  if (scored >= pairs) return "";
  return ", without one for " + std::to_string(pairs - scored) + " of the " +
         std::to_string(pairs) + " pairs that are true or false";
}

std::size_t count_pairs(const topobag::PlaceTruth& truth, topobag::PairRelation relation) {
  std::size_t pairs = 0;
  for (std::size_t query = 0; query < truth.num_queries(); ++query) {
    for (std::size_t candidate = 0; candidate < truth.num_candidates(); ++candidate) {
      if (truth.relation(query, candidate) == relation) ++pairs;
    }
  }
  return pairs;
}

}  // namespace program
