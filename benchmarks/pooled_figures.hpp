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

/// A look-up whose truth is known.
struct ScoredLookUp {
  std::optional<double> margin;  ///< of the answer: its score less the default's threshold; nothing
                                 ///< where none would be accepted at any threshold
  topobag::PoseVerdict truth = topobag::PoseVerdict::wrong;  ///< of that answer
};

/// What a threshold makes of look-ups.
struct Figures {
  std::size_t look_ups = 0;
  std::size_t accepted = 0;
  std::size_t correct = 0;
  std::size_t imprecise = 0;
  std::size_t wrong = 0;
};

/// The figures when answers with `least_margin` or more are accepted. O(n).
inline Figures figures_at(const std::vector<ScoredLookUp>& look_ups, double least_margin) {
  Figures figures;
  for (const ScoredLookUp& look_up : look_ups) {
    ++figures.look_ups;
    if (!look_up.margin || !(*look_up.margin >= least_margin)) continue;
    ++figures.accepted;
    if (look_up.truth == topobag::PoseVerdict::correct) ++figures.correct;
    if (look_up.truth == topobag::PoseVerdict::imprecise) ++figures.imprecise;
    if (look_up.truth == topobag::PoseVerdict::wrong) ++figures.wrong;
  }
  return figures;
}

/// The least margin to ask for so that at most `allowed` wrong answers are accepted; minus infinity
/// where there are no more than these. O(n log n).
inline double margin_for(const std::vector<ScoredLookUp>& look_ups, std::size_t allowed) {
  std::vector<double> wrong;
  for (const ScoredLookUp& look_up : look_ups) {
    if (look_up.margin && look_up.truth == topobag::PoseVerdict::wrong) {
      wrong.push_back(*look_up.margin);
    }
  }
  const double infinity = std::numeric_limits<double>::infinity();
  if (wrong.size() <= allowed) return -infinity;
  std::sort(wrong.begin(), wrong.end(), std::greater<>());
  return std::nextafter(wrong[allowed], infinity);
}

/// The margins that are asked for of a pool of look-ups.
struct PooledMargins {
  double beyond_best_false = 0.0;            ///< above every wrong answer
  double one_false_in_1000 = 0.0;            ///< wrong answers to at most one look-up in a thousand
  static constexpr double by_default = 0.0;  ///< what the library's default asks for
};

inline PooledMargins pooled_margins(const std::vector<ScoredLookUp>& pool) {
  return {margin_for(pool, 0), margin_for(pool, pool.size() / 1000)};
}
