// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include <topobag/evaluation/pose_error.hpp>

/// A query whose truth is known.
struct ScoredQuery {
  std::optional<double> margin;  ///< of the answer: its score less the default's threshold; nothing
                                 ///< where none would be accepted at any threshold
  topobag::PoseVerdict truth = topobag::PoseVerdict::wrong;  ///< of that answer
};

/// What a threshold makes of queries.
struct Figures {
  std::size_t queries = 0;
  std::size_t accepted = 0;
  std::size_t correct = 0;
  std::size_t imprecise = 0;
  std::size_t wrong = 0;
};

/// The figures when answers with `least_margin` or more are accepted. O(n).
inline Figures figures_at(const std::vector<ScoredQuery>& queries, double least_margin) {
  Figures figures;
  for (const ScoredQuery& query : queries) {
    ++figures.queries;
    if (!query.margin || !(*query.margin >= least_margin)) continue;
    ++figures.accepted;
    if (query.truth == topobag::PoseVerdict::correct) ++figures.correct;
    if (query.truth == topobag::PoseVerdict::imprecise) ++figures.imprecise;
    if (query.truth == topobag::PoseVerdict::wrong) ++figures.wrong;
  }
  return figures;
}

/// The least margin to ask for so that at most `allowed` wrong answers are accepted; minus infinity
/// where there are no more than these. O(n log n).
inline double margin_for(const std::vector<ScoredQuery>& queries, std::size_t allowed) {
  std::vector<double> wrong;
  for (const ScoredQuery& query : queries) {
    if (query.margin && query.truth == topobag::PoseVerdict::wrong) {
      wrong.push_back(*query.margin);
    }
  }
  const double infinity = std::numeric_limits<double>::infinity();
  if (wrong.size() <= allowed) return -infinity;
  std::sort(wrong.begin(), wrong.end(), std::greater<>());
  return std::nextafter(wrong[allowed], infinity);
}

/// The margins that are asked for of a pool of queries.
struct PooledMargins {
  double beyond_best_false = 0.0;            ///< above every wrong answer
  double one_false_in_1000 = 0.0;            ///< wrong answers to at most one query in a thousand
  static constexpr double by_default = 0.0;  ///< what the library's default asks for
};

inline PooledMargins pooled_margins(const std::vector<ScoredQuery>& pool) {
  return {margin_for(pool, 0), margin_for(pool, pool.size() / 1000)};
}
