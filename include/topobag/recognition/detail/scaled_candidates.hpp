// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <topobag/bag/query.hpp>
#include <topobag/graph/scaled_graph.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Whom to match: the map's best; of a query of unknown scale, the best by its likeness at any
/// scale of the range.
template <typename Map, typename Graph>
std::vector<Candidate> candidates_of(const Map& map, const Graph& query,
                                     const RecognitionOptions& options) {
  if (!options.matching.scale) return map.query(query, options.retrieval);
  const double step = 0.25;  // of the logarithm; some two bins of distances of 1 m
  const ScaleRange& range = *options.matching.scale;
  const double steps = std::ceil(range.log_width() / step);
  std::map<KeyframeId, double> best;
  for (double i = 0.0; i <= steps; ++i) {
    const double scale = range.least * std::exp(range.log_width() * i / steps);
    for (const Candidate& found : map.query(scaled(query, scale), options.retrieval)) {
      const auto [known, is_new] = best.emplace(found.id, found.similarity);
      if (!is_new) known->second = std::max(known->second, found.similarity);
    }
  }
  std::vector<Candidate> candidates;
  candidates.reserve(best.size());
  for (const auto& [id, similarity] : best) candidates.push_back({id, similarity});
  std::sort(candidates.begin(), candidates.end());
  if (candidates.size() > options.retrieval.max_results) {
    candidates.resize(options.retrieval.max_results);
  }
  return candidates;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
