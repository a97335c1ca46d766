// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// A histogram over 64-bit words of which few occur: entries in ascending order of their words.
class SparseHistogram {
 public:
  /// One word that occurs.
  struct Entry {
    std::uint64_t word = 0;  ///< what is counted
    double weight = 0.0;     ///< how much of it

    friend bool operator<(const Entry& l, const Entry& r) noexcept {
      return std::tie(l.word, l.weight) < std::tie(r.word, r.weight);
    }
    friend bool operator==(const Entry& l, const Entry& r) noexcept {
      return l.word == r.word && l.weight == r.weight;
    }
  };

  SparseHistogram() = default;

  /// Sums votes per word; votes of weight 0 leave no entry. The order of the votes does not matter,
  /// to the last bit.
  /// Precondition: the weights are finite. O(m log m) for m votes.
  explicit SparseHistogram(std::vector<Entry> votes) : entries_(std::move(votes)) {
    std::sort(entries_.begin(), entries_.end());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].weight == 0.0) continue;
      if (kept > 0 && entries_[kept - 1].word == entries_[i].word) {
        entries_[kept - 1].weight += entries_[i].weight;
      } else {
        entries_[kept++] = entries_[i];
      }
    }
    entries_.resize(kept);
    for (const Entry& e : entries_) total_ += e.weight;
  }

  /// Ascending word, each once.
  const std::vector<Entry>& entries() const noexcept { return entries_; }
  bool empty() const noexcept { return entries_.empty(); }

  /// Sum of all weights.
  double total() const noexcept { return total_; }

  /// Scaled to Euclidean length 1; one that is all zero becomes empty. O(entries).
  SparseHistogram normalized() const {
    double largest = 0.0;
    for (const Entry& e : entries_) largest = std::max(largest, std::abs(e.weight));
    if (!(largest > 0.0)) return {};
    double sum = 0.0;
    for (const Entry& e : entries_) sum += (e.weight / largest) * (e.weight / largest);
    std::vector<Entry> unit = entries_;
    for (Entry& e : unit) e.weight = e.weight / largest / std::sqrt(sum);
    return SparseHistogram(std::move(unit));
  }

  /// Lexicographic: a total order, by which symmetric measures sort their arguments.
  friend bool operator<(const SparseHistogram& l, const SparseHistogram& r) noexcept {
    return l.entries_ < r.entries_;
  }
  friend bool operator==(const SparseHistogram& l, const SparseHistogram& r) noexcept {
    return l.entries_ == r.entries_;
  }

 private:
  std::vector<Entry> entries_;
  double total_ = 0.0;
};

namespace detail {

/// Σ term(weight in a, weight in b) over the words of both. O(entries of both).
template <typename Term>
double sum_over_common(const SparseHistogram& a, const SparseHistogram& b, const Term& term) {
  double sum = 0.0;
  auto i = a.entries().begin();
  auto j = b.entries().begin();
  while (i != a.entries().end() && j != b.entries().end()) {
    if (i->word == j->word) {
      sum += term((i++)->weight, (j++)->weight);
    } else if (i->word < j->word) {
      ++i;
    } else {
      ++j;
    }
  }
  return sum;
}

/// Of what two multisets have in common and of the total of each.
inline double jaccard_index(double common, double total_a, double total_b) noexcept {
  const double all = total_a + total_b - common;
  return all > 0.0 ? std::min(common / all, 1.0) : 0.0;
}

}  // namespace detail

/// Σ of the products of the weights of common words. O(entries of both).
inline double dot(const SparseHistogram& a, const SparseHistogram& b) {
  return detail::sum_over_common(a, b, [](double x, double y) { return x * y; });
}

/// Cosine of two histograms that are `normalized`, negative ones raised to 0: in [0, 1].
/// O(entries of both).
inline double unit_cosine(const SparseHistogram& a, const SparseHistogram& b) {
  return std::clamp(dot(a, b), 0.0, 1.0);
}

/// Σ min / Σ max over the words of two histograms without negative weights, the Jaccard index of
/// multisets: in [0, 1], 1 for equal ones, 0 when both are empty. O(entries of both).
inline double jaccard(const SparseHistogram& a, const SparseHistogram& b) {
  const double common =
      detail::sum_over_common(a, b, [](double x, double y) { return std::min(x, y); });
  return detail::jaccard_index(common, a.total(), b.total());
}

}  // namespace v0
}  // namespace topobag
