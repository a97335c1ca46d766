// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// A share of queries in [0, 1].
struct FalseAcceptRate {
  double rate = 1.0;         ///< share of false queries
  bool extrapolated = true;  ///< beyond what was seen
};

/// A score to ask for.
struct ScoreThreshold {
  double score = 0.0;        ///< the score to ask for
  bool extrapolated = true;  ///< beyond what was seen
};

/// The best scores of queries that are known to be false, and what they say of the next one.
///
/// Within the scores seen, the rate of a threshold is the conformal (1 + those at or above it) /
/// (1 + all): of a further query of the same kind it is the probability to be accepted, or more.
/// Beyond them the scores' upper tail goes on exponentially, as that of a −log10 of a probability
/// does: the mean excess over the least of the best tenth gives its slope, which is never
/// taken for steeper than the chance model's own, 10^−score.
class FalseScores {
 public:
  /// Of no queries.
  FalseScores() = default;

  /// What another one's `size` and `scores` told. Throws InvalidValue when a score is not finite,
  /// or when there are more scores than queries. O(n log n).
  FalseScores(std::size_t queries, std::vector<double> scores)
      : queries_(queries), scores_(std::move(scores)) {
    if (scores_.size() > queries_) throw InvalidValue("there are more false scores than queries");
    for (const double score : scores_) require_finite(score);
    std::sort(scores_.begin(), scores_.end(), std::greater<>());
  }

  /// @param score  the least threshold that would have refused the query; nothing when every one
  /// does. Throws InvalidValue when it is not finite. O(n).
  void add(std::optional<double> score) {
    if (score) require_finite(*score);
    ++queries_;
    if (!score) return;
    scores_.insert(std::upper_bound(scores_.begin(), scores_.end(), *score, std::greater<>()),
                   *score);
  }

  /// All queries, the ones without a score too.
  std::size_t size() const noexcept { return queries_; }

  /// Those of the queries that had one, falling.
  const std::vector<double>& scores() const noexcept { return scores_; }

  /// The share of false queries that a threshold accepts. Falls with it. O(n).
  FalseAcceptRate rate(double threshold) const {
    const auto above =
        std::upper_bound(scores_.begin(), scores_.end(), threshold, std::greater<>());
    const auto accepted = static_cast<double>(above - scores_.begin());
    if (accepted > 0.0) return {(accepted + 1.0) / (count() + 1.0), false};
    const Tail tail = upper_tail();
    const double beyond = tail.share * std::exp(-(threshold - tail.start) / tail.mean_excess);
    return {std::min(beyond, 1.0 / (count() + 1.0)), true};
  }

  /// The least threshold that accepts no larger share of false queries than `rate`. Extrapolated
  /// for a rate below 1 / (queries + 1). Throws InvalidValue unless 0 < rate <= 1. O(n).
  ScoreThreshold threshold(double rate) const {
    if (!(rate > 0.0 && rate <= 1.0)) {
      throw InvalidValue("a false-accept rate must be in (0, 1]");
    }
    const double allowed = std::floor(rate * (count() + 1.0)) - 1.0;
    if (allowed < 0.0) {
      const Tail tail = upper_tail();
      const double beyond = tail.start + tail.mean_excess * std::log(tail.share / rate);
      return {scores_.empty() ? beyond : std::max(beyond, just_above(scores_.front())), true};
    }
    const auto rank = static_cast<std::size_t>(allowed);
    if (rank < scores_.size()) return {just_above(scores_[rank]), false};
    return {scores_.empty() ? 0.0 : std::min(0.0, scores_.back()), false};
  }

 private:
  struct Tail {
    double start;        // score
    double share;        // of the queries above it
    double mean_excess;  // score
  };

  static void require_finite(double score) {
    if (!std::isfinite(score)) throw InvalidValue("a false score must be finite");
  }

  double count() const { return static_cast<double>(queries_); }

  static double just_above(double score) {
    return std::nextafter(score, std::numeric_limits<double>::infinity());
  }

  Tail upper_tail() const {
    const double least_excess = 1.0 / std::log(10.0);
    if (scores_.empty()) return {0.0, 1.0 / (count() + 1.0), least_excess};
    const auto wanted = static_cast<std::size_t>(std::ceil(tail_share * count()));
    const std::size_t size = std::min(scores_.size(), std::max<std::size_t>(wanted, 10));
    const double start = scores_[size - 1];
    double excess = 0.0;
    for (std::size_t i = 0; i < size; ++i) excess += scores_[i] - start;
    return {start, (static_cast<double>(size) + 1.0) / (count() + 1.0),
            std::max(least_excess, excess / static_cast<double>(size))};
  }

  static constexpr double tail_share = 0.1;  // of the queries, whose scores make the tail

  std::size_t queries_ = 0;
  std::vector<double> scores_;  // falling
};

}  // namespace v0
}  // namespace topobag
