// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <topobag/assert.hpp>
#include <topobag/bag/detail/index/coarse_histogram.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// For every leaf, a group of graphs, the greatest weight that each word has in one of them: a
/// query's Σ min with it is at least that with each graph.
///
/// Word by word: a byte for every leaf, or, where few leaves have the word, their numbers.
class LeafBounds {
 public:
  static constexpr std::size_t max_leaves = 65536;

  std::size_t leaves() const noexcept { return leaves_; }

  /// Adds to `sums[leaf]` the query's Σ min with each leaf, in units of 1 / `coarse_steps`.
  /// Precondition: the query's weights fit into a sum. O(Σ leaves that have a word).
  void add_common(const CoarseHistogram& query, std::uint16_t* sums) const {
    DenseGroup group;
    auto column = columns_.begin();
    for (const CoarseEntry& entry : query) {
      column = std::lower_bound(column, columns_.end(), entry.word,
                                [](const Column& c, std::uint32_t word) { return c.word < word; });
      if (column == columns_.end()) break;
      if (column->word != entry.word) continue;
      const std::uint8_t* weights = weights_.data() + column->weights;
      const auto cap = static_cast<std::uint8_t>(std::min(entry.weight, full));
      if (is_dense(*column)) {
        if (!group.fits(cap)) add_dense(group, sums);
        group.add(weights, cap);
      } else {
        const std::uint16_t* ids = ids_.data() + column->ids;
        for (std::size_t i = 0; i < column->size; ++i) {
          sums[ids[i]] = static_cast<std::uint16_t>(sums[ids[i]] + std::min(weights[i], cap));
        }
      }
      // A byte that is full may stand for more than it holds.
      if (entry.weight > full) add_beyond(*column, entry.weight - full, sums);
    }
    add_dense(group, sums);
  }

  std::size_t bytes() const noexcept {
    return columns_.capacity() * sizeof(Column) + weights_.capacity() +
           ids_.capacity() * sizeof(std::uint16_t);
  }

  /// Collects leaves, one after another.
  class Builder {
   public:
    /// @param leaf  the leaf's greatest weights, ascending words
    void add(const CoarseHistogram& leaf) {
      TOPOBAG_ASSERT(leaves_ < max_leaves);
      for (const CoarseEntry& entry : leaf) {
        postings_.push_back({entry.word, static_cast<std::uint16_t>(leaves_),
                             static_cast<std::uint8_t>(std::min(entry.weight, full))});
      }
      ++leaves_;
    }

    /// All leaves of another, after those that are there.
    void add(const LeafBounds& other) {
      TOPOBAG_ASSERT(leaves_ + other.leaves_ <= max_leaves);
      for (const Column& column : other.columns_) {
        other.for_each(column, [&](std::size_t leaf, std::uint8_t weight) {
          postings_.push_back({column.word, static_cast<std::uint16_t>(leaves_ + leaf), weight});
        });
      }
      leaves_ += other.leaves_;
    }

    LeafBounds build() {
      std::sort(postings_.begin(), postings_.end(), [](const Posting& l, const Posting& r) {
        return l.word != r.word ? l.word < r.word : l.leaf < r.leaf;
      });
      LeafBounds bounds;
      bounds.leaves_ = leaves_;
      for (std::size_t begin = 0, end = 0; begin < postings_.size(); begin = end) {
        while (end < postings_.size() && postings_[end].word == postings_[begin].word) ++end;
        bounds.add_column(postings_.data() + begin, postings_.data() + end);
      }
      bounds.columns_.shrink_to_fit();
      bounds.weights_.shrink_to_fit();
      bounds.ids_.shrink_to_fit();
      return bounds;
    }

   private:
    friend class LeafBounds;
    struct Posting {
      std::uint32_t word;
      std::uint16_t leaf;
      std::uint8_t weight;
    };

    std::size_t leaves_ = 0;
    std::vector<Posting> postings_;
  };

 private:
  static constexpr std::uint32_t full = 255;
  static constexpr std::uint32_t no_ids = std::numeric_limits<std::uint32_t>::max();
  /// A word in more than one leaf of so many is dense: as fast as the numbers or faster.
  static constexpr std::size_t dense_from = 20;

  struct Column {
    std::uint32_t word;
    std::uint32_t size;     ///< leaves that have the word
    std::uint32_t weights;  ///< where its bytes begin
    std::uint32_t ids;      ///< where its leaves' numbers begin; `no_ids` when dense
  };
  static bool is_dense(const Column& column) noexcept { return column.ids == no_ids; }

  /// Some dense columns whose sums fit into a byte: they are added up before the sums are touched.
  struct DenseGroup {
    static constexpr std::size_t capacity = 4;
    const std::uint8_t* weights[capacity] = {};
    std::uint8_t caps[capacity] = {};
    std::size_t size = 0;
    std::uint32_t sum = 0;

    bool fits(std::uint8_t cap) const noexcept { return size < capacity && sum + cap <= full; }
    void add(const std::uint8_t* column, std::uint8_t cap) noexcept {
      weights[size] = column;
      caps[size++] = cap;
      sum += cap;
    }
  };

  /// Adds the group's columns to the sums and empties it.
  void add_dense(DenseGroup& group, std::uint16_t* sums) const {
    if (group.size == 0) return;
    // Columns that are not there count as the first, of which they take nothing.
    for (std::size_t i = group.size; i < DenseGroup::capacity; ++i) {
      group.weights[i] = group.weights[0];
    }
    const auto [a, b, c, d] = group.weights;
    const auto [cap_a, cap_b, cap_c, cap_d] = group.caps;
    for (std::size_t leaf = 0; leaf < leaves_; ++leaf) {
      const auto sum =
          static_cast<std::uint8_t>(std::min(a[leaf], cap_a) + std::min(b[leaf], cap_b) +
                                    std::min(c[leaf], cap_c) + std::min(d[leaf], cap_d));
      sums[leaf] = static_cast<std::uint16_t>(sums[leaf] + sum);
    }
    group = {};
  }

  template <typename Visit>
  void for_each(const Column& column, const Visit& visit) const {
    const std::size_t end = is_dense(column) ? leaves_ : column.size;
    for (std::size_t i = 0; i < end; ++i) {
      const std::uint8_t weight = weights_[column.weights + i];
      if (weight > 0) visit(is_dense(column) ? i : ids_[column.ids + i], weight);
    }
  }

  void add_beyond(const Column& column, std::uint32_t rest, std::uint16_t* sums) const {
    for_each(column, [&](std::size_t leaf, std::uint8_t weight) {
      if (weight == full) sums[leaf] = static_cast<std::uint16_t>(sums[leaf] + rest);
    });
  }

  void add_column(const Builder::Posting* begin, const Builder::Posting* end) {
    const auto size = static_cast<std::size_t>(end - begin);
    Column column{begin->word, static_cast<std::uint32_t>(size),
                  static_cast<std::uint32_t>(weights_.size()), no_ids};
    if (size * dense_from > leaves_) {
      weights_.resize(weights_.size() + leaves_, 0);
      for (const auto* p = begin; p != end; ++p) weights_[column.weights + p->leaf] = p->weight;
    } else {
      column.ids = static_cast<std::uint32_t>(ids_.size());
      for (const auto* p = begin; p != end; ++p) {
        weights_.push_back(p->weight);
        ids_.push_back(p->leaf);
      }
    }
    columns_.push_back(column);
  }

  std::size_t leaves_ = 0;
  std::vector<Column> columns_;  ///< ascending words
  std::vector<std::uint8_t> weights_;
  std::vector<std::uint16_t> ids_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
