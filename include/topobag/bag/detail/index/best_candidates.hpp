// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <queue>
#include <vector>

#include <topobag/bag/detail/index/bag_parts.hpp>
#include <topobag/bag/query.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// How far two ways to work out the same score may lie apart. The sums of a float's accuracy in
/// them are good to 10⁻⁷.
inline constexpr double score_slack = 2e-6;

/// The candidates that may be among the k best, gathered by scores that are right but for
/// `score_slack` and then told apart by exact ones.
class BestCandidates {
 public:
  BestCandidates(std::size_t count, double min_similarity)
      : count_(count), min_similarity_(min_similarity) {}

  /// A graph that scores less is none of the best.
  double floor() const noexcept {
    return best_.size() < count_ ? min_similarity_
                                 : std::max(min_similarity_, best_.top() - score_slack);
  }
  /// Whether one with this score, or bound of it, may be wanted.
  bool wants(double score) const noexcept { return score + score_slack >= floor(); }

  void add(EntryPlace place, const StoredEntry& entry, double score) {
    if (!wants(score)) return;
    if (score <= 0.0) {
      add_nothing_in_common(entry.id);
      return;
    }
    gathered_.push_back({place, entry.id, score});
    best_.push(score);
    if (best_.size() > count_) best_.pop();
  }

  /// With nothing in common the score is 0, to the last bit.
  void add_nothing_in_common(KeyframeId id) {
    zeros_.push(id);
    if (zeros_.size() > count_) zeros_.pop();
  }

  /// The best, by `score_of(entry)`, which is exact and asked for no more than it takes.
  template <typename ScoreOf>
  std::vector<Candidate> finish(const BagParts& parts, const ScoreOf& score_of) {
    return finish(parts, score_of, [](EntryPlace, double score) { return score; });
  }

  /// The same, where `score_of` depends on the graph alone and `whole(place, score)` makes of it
  /// what was added.
  template <typename ScoreOf, typename Whole>
  std::vector<Candidate> finish(const BagParts& parts, const ScoreOf& score_of,
                                const Whole& whole) {
    std::sort(gathered_.begin(), gathered_.end(), [](const Gathered& l, const Gathered& r) {
      return l.score != r.score ? l.score > r.score : l.id < r.id;
    });
    std::vector<Candidate> found;
    StoredEntry last;
    double last_score = 0.0;
    for (const Gathered& candidate : gathered_) {
      if (!wants(candidate.score)) break;
      const StoredEntry entry = parts.entry(candidate.place);
      const bool same = last.graph != nullptr && entry.graph_size == last.graph_size &&
                        std::memcmp(entry.graph, last.graph, last.graph_size) == 0;
      if (!same) last_score = score_of(entry);
      last = entry;
      const double score = whole(candidate.place, last_score);
      if (score >= min_similarity_) found.push_back({candidate.id, score});
    }
    for (; !zeros_.empty(); zeros_.pop()) {
      if (min_similarity_ <= 0.0) found.push_back({zeros_.top(), 0.0});
    }
    std::sort(found.begin(), found.end());
    if (found.size() > count_) found.resize(count_);
    return found;
  }

 private:
  struct Gathered {
    EntryPlace place;
    KeyframeId id;
    double score;
  };

  std::size_t count_;
  double min_similarity_;
  std::vector<Gathered> gathered_;
  std::priority_queue<double, std::vector<double>, std::greater<double>> best_;
  std::priority_queue<KeyframeId> zeros_;  ///< the smallest ids
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
