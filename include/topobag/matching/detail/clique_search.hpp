// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <topobag/matching/detail/bit_matrix.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Enumerates the large maximal cliques of a graph whose vertices fall into groups that hold no
/// edge inside (here: pairs that share a query node), so that the number of groups met bounds a
/// clique's size.
///
/// Bron–Kerbosch with pivoting, cut where a branch cannot reach `size >= largest - slack`; the
/// largest is at first what a greedy search finds. Exact unless the budget of steps ends first.
/// Deterministic.
class CliqueSearch {
 public:
  /// @param adjacency  symmetric, no self-loops
  /// @param group      group of each vertex, ascending
  CliqueSearch(const BitMatrix& adjacency, const std::vector<std::size_t>& group)
      : adjacency_(adjacency),
        group_(group),
        n_(group.size()),
        words_(adjacency.words()),
        candidates_(n_ + 1, n_),
        excluded_(n_ + 1, n_) {
    clique_.reserve(n_);
  }

  /// Calls `report(clique)` for maximal cliques (ascending vertices) of at least `min_size`
  /// vertices and at most `slack` fewer than the largest seen so far; where the budget ends before
  /// any, for the greedy search's. Returns the number of steps, `budget` when it ended there.
  template <typename Report>
  std::size_t run(std::size_t min_size, std::size_t slack, std::size_t budget, Report&& report) {
    min_size_ = min_size;
    slack_ = slack;
    budget_ = budget;
    steps_ = 0;
    found_any_ = false;
    if (n_ == 0) return 0;
    std::vector<std::size_t> greedy = greedy_clique();
    largest_ = greedy.size();
    take_all();
    expand(report);
    if (!found_any_ && largest_ >= min_size_) report(std::move(greedy));
    return steps_;
  }

 private:
  /// Begins with the empty clique, which every vertex may extend.
  void take_all() {
    clique_.clear();
    std::fill(candidates_.row(0), candidates_.row(0) + words_, BitWord{0});
    std::fill(excluded_.row(0), excluded_.row(0) + words_, BitWord{0});
    for (std::size_t v = 0; v < n_; ++v) candidates_.set(0, v);
  }

  /// The clique that each time takes the vertex with the most neighbours among those left. From its
  /// size on the search need not look for smaller ones.
  std::vector<std::size_t> greedy_clique() {
    take_all();
    BitWord* left = candidates_.row(0);
    std::vector<std::size_t> clique;
    while (groups_met(left) > 0) {
      clique.push_back(best_pivot(left, excluded_.row(0)));
      const BitWord* neighbors = adjacency_.row(clique.back());
      for (std::size_t w = 0; w < words_; ++w) left[w] &= neighbors[w];
    }
    std::sort(clique.begin(), clique.end());
    return clique;
  }

  template <typename Report>
  void expand(Report& report) {
    if (steps_ >= budget_) return;
    ++steps_;
    const std::size_t depth = clique_.size();
    BitWord* candidates = candidates_.row(depth);
    BitWord* excluded = excluded_.row(depth);
    const std::size_t groups = groups_met(candidates);
    if (groups == 0) {
      const bool maximal =
          std::all_of(excluded, excluded + words_, [](BitWord w) { return w == 0; });
      if (maximal && depth >= goal()) {
        largest_ = std::max(largest_, depth);
        found_any_ = true;
        std::vector<std::size_t> sorted = clique_;
        std::sort(sorted.begin(), sorted.end());
        report(std::move(sorted));
      }
      return;
    }
    if (depth + groups < goal()) return;

    const BitWord* pivot = adjacency_.row(best_pivot(candidates, excluded));
    for (std::size_t w = 0; w < words_; ++w) {
      for (BitWord branch = candidates[w] & ~pivot[w]; branch != 0; branch &= branch - 1) {
        const std::size_t v = w * 64 + lowest_bit(branch);
        const BitWord* neighbors = adjacency_.row(v);
        for (std::size_t k = 0; k < words_; ++k) {
          candidates_.row(depth + 1)[k] = candidates[k] & neighbors[k];
          excluded_.row(depth + 1)[k] = excluded[k] & neighbors[k];
        }
        clique_.push_back(v);
        expand(report);
        clique_.pop_back();
        candidates_.reset(depth, v);
        excluded_.set(depth, v);
      }
    }
  }

  std::size_t goal() const noexcept {
    return std::max(min_size_, largest_ > slack_ ? largest_ - slack_ : std::size_t{0});
  }

  std::size_t groups_met(const BitWord* set) const noexcept {
    std::size_t count = 0;
    std::size_t last = std::numeric_limits<std::size_t>::max();  // no group has this number
    for (std::size_t w = 0; w < words_; ++w) {
      for (BitWord bits = set[w]; bits != 0; bits &= bits - 1) {
        const std::size_t g = group_[w * 64 + lowest_bit(bits)];
        count += g != last ? 1 : 0;
        last = g;
      }
    }
    return count;
  }

  /// The vertex, candidate or excluded, that leaves the fewest candidates to branch on; the first
  /// that leaves none is not outdone.
  std::size_t best_pivot(const BitWord* candidates, const BitWord* excluded) const noexcept {
    const int all = common(candidates, candidates);
    std::size_t best = 0;
    int most = -1;
    for (std::size_t w = 0; w < words_; ++w) {
      for (BitWord bits = candidates[w] | excluded[w]; bits != 0; bits &= bits - 1) {
        const std::size_t v = w * 64 + lowest_bit(bits);
        const int covered = common(candidates, adjacency_.row(v));
        if (covered == all) return v;
        if (covered > most) {
          most = covered;
          best = v;
        }
      }
    }
    return best;
  }

  int common(const BitWord* a, const BitWord* b) const noexcept {
    int count = 0;
    for (std::size_t k = 0; k < words_; ++k) count += popcount(a[k] & b[k]);
    return count;
  }

  const BitMatrix& adjacency_;
  const std::vector<std::size_t>& group_;
  std::size_t n_;
  std::size_t words_;
  BitMatrix candidates_;  ///< row d: vertices that may extend a clique of d
  BitMatrix excluded_;    ///< row d: vertices that would extend it and were branched on already
  std::vector<std::size_t> clique_;
  std::size_t min_size_ = 0;
  std::size_t slack_ = 0;
  std::size_t budget_ = 0;
  std::size_t steps_ = 0;
  std::size_t largest_ = 0;
  bool found_any_ = false;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
