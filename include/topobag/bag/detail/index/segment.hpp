// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/bag/detail/codec/node_scan.hpp>
#include <topobag/bag/detail/index/leaf_bounds.hpp>
#include <topobag/bag/detail/index/segment_infos.hpp>
#include <topobag/bag/detail/index/sketch.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Entries that never change, with the index over them. A slot is an entry's place; a leaf is some
/// neighbouring slots.
class Segment {
 public:
  /// So many graphs share a leaf at most. More make the index smaller and its bounds looser.
  static constexpr std::size_t max_leaf_size = 24;
  static constexpr std::size_t max_bytes = std::numeric_limits<std::uint32_t>::max();

  /// Of the totals in a leaf.
  struct TotalRange {
    float least = 0.0F, greatest = 0.0F;
  };

  std::size_t size() const noexcept { return ids_.size(); }
  KeyframeId id(std::size_t slot) const noexcept { return ids_[slot]; }
  const std::vector<KeyframeId>& ids() const noexcept { return ids_; }
  const std::uint8_t* graph(std::size_t slot) const noexcept {
    return bytes_.data() + begins_[slot];
  }
  std::size_t graph_size(std::size_t slot) const noexcept {
    return begins_[slot + 1] - begins_[slot];
  }
  std::size_t graph_bytes() const noexcept { return begins_.back(); }

  /// Sum of the weights of the graph's histogram, to a float's accuracy.
  float total(std::size_t slot) const noexcept { return sketches_[slot].total(); }

  const Sketch& sketch(std::size_t slot) const noexcept { return sketches_[slot]; }

  std::size_t leaves() const noexcept { return leaf_begins_.size() - 1; }
  std::size_t leaf_begin(std::size_t leaf) const noexcept { return leaf_begins_[leaf]; }
  std::size_t leaf_end(std::size_t leaf) const noexcept { return leaf_begins_[leaf + 1]; }
  const TotalRange& total_range(std::size_t leaf) const noexcept { return total_ranges_[leaf]; }
  /// The leaves' least totals in units of 1 / `coarse_steps`, rounded down, as far as they fit.
  const std::uint16_t* least_totals() const noexcept { return least_totals_.data(); }
  const LeafBounds& bounds() const noexcept { return bounds_; }

  /// How many ids are less than this one. O(log n).
  std::size_t rank(KeyframeId id) const {
    std::size_t low = 0, high = ids_.size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (ids_[by_id(middle)] < id) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
  /// The slot whose id has this rank.
  std::size_t by_id(std::size_t rank) const { return by_id_.empty() ? rank : by_id_[rank]; }
  /// O(log n).
  std::optional<std::size_t> slot_of(KeyframeId id) const {
    const std::size_t at = rank(id);
    if (at == size() || ids_[by_id(at)] != id) return std::nullopt;
    return by_id(at);
  }

  /// Of the index alone: what a plain list of the entries would not need.
  std::size_t index_bytes() const noexcept {
    return bounds_.bytes() + sketches_.capacity() * sizeof(Sketch) +
           leaf_begins_.capacity() * sizeof(std::uint32_t) +
           total_ranges_.capacity() * sizeof(TotalRange) +
           least_totals_.capacity() * sizeof(std::uint16_t) +
           by_id_.capacity() * sizeof(std::uint32_t);
  }
  std::size_t entry_bytes() const noexcept {
    return ids_.capacity() * sizeof(KeyframeId) + begins_.capacity() * sizeof(std::uint32_t) +
           sizeof(*this);
  }

  template <typename Similarity>
  class Builder;

 private:
  std::vector<KeyframeId> ids_;
  std::vector<std::uint32_t> begins_{0};  ///< of the graphs in `bytes_`, and their end
  std::vector<std::uint8_t> bytes_;
  std::vector<Sketch> sketches_;
  std::vector<std::uint32_t> by_id_;  ///< slots by ascending id; empty where they are so already

  std::vector<std::uint32_t> leaf_begins_{0};  ///< first slots, and the end
  std::vector<TotalRange> total_ranges_;       ///< by leaf
  std::vector<std::uint16_t> least_totals_;    ///< by leaf
  LeafBounds bounds_;
};

/// Puts a segment together, slot by slot.
template <typename Similarity>
class Segment::Builder {
 public:
  explicit Builder(const Similarity& similarity) : similarity_(&similarity) {}

  std::size_t size() const noexcept { return segment_.ids_.size(); }
  std::size_t graph_bytes() const noexcept { return segment_.bytes_.size(); }

  /// @param graph  `size` encoded bytes and `scan_margin` more
  void add(KeyframeId id, const EntryInfo& info, const std::uint8_t* graph, std::size_t size) {
    votes_.clear();
    double total = 0.0;
    similarity_->for_each_vote(scan_(graph), [&](std::uint64_t word, double weight) {
      total += weight;
      votes_.emplace_back(static_cast<std::uint32_t>(word), weight);
    });
    const CoarseHistogram graph_histogram = coarse_histogram(votes_);
    // Alike graphs share a leaf: one that is not would loosen the bounds of all.
    const std::size_t in_leaf = this->size() - segment_.leaf_begins_.back();
    if (in_leaf == max_leaf_size || (in_leaf > 0 && !is_like_leaf(graph_histogram))) end_leaf();
    append(id, info, graph, size);
    segment_.sketches_.emplace_back(graph_histogram, static_cast<float>(total));
    raise_to(graph_histogram);
  }

  /// All of another, with its leaves as they are.
  void add(const Segment& other, const SegmentInfos& infos) {
    end_leaf();
    for (std::size_t slot = 0; slot < other.size(); ++slot) {
      append(other.id(slot), infos[slot], other.graph(slot), other.graph_size(slot));
      segment_.sketches_.push_back(other.sketch(slot));
    }
    const std::uint32_t before = segment_.leaf_begins_.back();
    for (std::size_t leaf = 0; leaf < other.leaves(); ++leaf) {
      segment_.leaf_begins_.push_back(before + other.leaf_begins_[leaf + 1]);
    }
    bounds_.add(other.bounds_);
  }

  Segment build() {
    end_leaf();
    Segment& s = segment_;
    s.bytes_.insert(s.bytes_.end(), scan_margin, 0);
    s.bounds_ = bounds_.build();
    for (std::size_t leaf = 0; leaf < s.leaves(); ++leaf) {
      TotalRange range{s.total(s.leaf_begin(leaf)), s.total(s.leaf_begin(leaf))};
      for (std::size_t slot = s.leaf_begin(leaf) + 1; slot < s.leaf_end(leaf); ++slot) {
        range.least = std::min(range.least, s.total(slot));
        range.greatest = std::max(range.greatest, s.total(slot));
      }
      s.total_ranges_.push_back(range);
      const double steps = static_cast<double>(range.least) * coarse_steps;
      s.least_totals_.push_back(static_cast<std::uint16_t>(std::min(steps, 65535.0)));
    }
    sort_ids();
    s.ids_.shrink_to_fit();
    s.begins_.shrink_to_fit();
    s.bytes_.shrink_to_fit();
    s.sketches_.shrink_to_fit();
    s.leaf_begins_.shrink_to_fit();
    s.total_ranges_.shrink_to_fit();
    s.least_totals_.shrink_to_fit();
    return std::move(s);
  }

  /// What is known of the entries.
  SegmentInfos take_infos() {
    infos_.shrink_to_fit();
    return std::move(infos_);
  }

 private:
  void append(KeyframeId id, const EntryInfo& info, const std::uint8_t* graph, std::size_t size) {
    segment_.ids_.push_back(id);
    infos_.push_back(id, info);
    segment_.bytes_.insert(segment_.bytes_.end(), graph, graph + size);
    segment_.begins_.push_back(static_cast<std::uint32_t>(segment_.bytes_.size()));
  }

  /// Whether half of the graph's weights are in the leaf already.
  bool is_like_leaf(const CoarseHistogram& graph) const {
    std::uint64_t common = 0, total = 0;
    auto i = leaf_.begin();
    for (const CoarseEntry& entry : graph) {
      total += entry.weight;
      while (i != leaf_.end() && i->word < entry.word) ++i;
      if (i != leaf_.end() && i->word == entry.word) common += std::min(i->weight, entry.weight);
    }
    return 2 * common >= total;
  }

  /// Takes a graph's weights into the leaf's greatest.
  void raise_to(const CoarseHistogram& graph) {
    raised_.clear();
    auto i = leaf_.begin();
    for (const CoarseEntry& entry : graph) {
      while (i != leaf_.end() && i->word < entry.word) raised_.push_back(*i++);
      if (i != leaf_.end() && i->word == entry.word) {
        raised_.push_back({entry.word, std::max(i->weight, entry.weight)});
        ++i;
      } else {
        raised_.push_back(entry);
      }
    }
    raised_.insert(raised_.end(), i, leaf_.end());
    leaf_.swap(raised_);
  }

  void end_leaf() {
    if (segment_.leaf_begins_.back() == size()) return;
    segment_.leaf_begins_.push_back(static_cast<std::uint32_t>(size()));
    bounds_.add(leaf_);
    leaf_.clear();
  }

  void sort_ids() {
    const auto& ids = segment_.ids_;
    if (std::is_sorted(ids.begin(), ids.end())) return;
    segment_.by_id_.resize(ids.size());
    std::iota(segment_.by_id_.begin(), segment_.by_id_.end(), 0U);
    std::sort(segment_.by_id_.begin(), segment_.by_id_.end(),
              [&](std::uint32_t l, std::uint32_t r) { return ids[l] < ids[r]; });
  }

  const Similarity* similarity_;
  Segment segment_;
  SegmentInfos infos_;
  LeafBounds::Builder bounds_;
  CoarseHistogram leaf_, raised_;
  NodeScan scan_;
  std::vector<CoarseVote> votes_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
