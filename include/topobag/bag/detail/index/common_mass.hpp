// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/bag/detail/codec/node_scan.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The similarity of two histograms of which so much is common: Jaccard's, of weights. 0 of nothing
/// in common.
inline double similarity_of(double common, double total_a, double total_b) noexcept {
  return common > 0.0 ? common / (total_a + total_b - common) : 0.0;
}

/// Σ min of a query's histogram with those of stored graphs, straight from their nodes: what
/// `jaccard` finds in common, but for the rounding of the sum.
///
/// Looks up what words the query has instead of making the other histogram: O(n²) without a sort.
/// Keeps scratch space, so one thread at a time.
template <typename Similarity>
class CommonMass {
 public:
  /// @param labels  of the query's nodes
  CommonMass(const Similarity& similarity, const SparseHistogram& query,
             std::vector<ClassId> labels)
      : similarity_(similarity), labels_(std::move(labels)) {
    std::sort(labels_.begin(), labels_.end());
    labels_.erase(std::unique(labels_.begin(), labels_.end()), labels_.end());
    for (const ClassId low : labels_) {
      for (const ClassId high : labels_) {
        pairs_.push_back({Similarity::pair_words(low, high), similarity.pair_vote(low, high)});
      }
      for (const std::uint64_t side : {0U, 1U}) {
        sides_.push_back(
            {Similarity::side_words(low, side), similarity.size_vote * similarity.weights(low)});
      }
      alone_.push_back(
          {Similarity::class_word(low), similarity.class_vote * similarity.weights(low)});
    }
    std::size_t slots = 64;
    while (slots < 4 * query.entries().size()) slots *= 2;
    slots_.resize(slots);
    mask_ = slots - 1;
    for (const SparseHistogram::Entry& entry : query.entries()) {
      Slot& slot = slot_of(entry.word);
      slot.word = entry.word;
      slot.query = entry.weight;
    }
  }

  double operator()(const std::vector<ScannedNode>& nodes) {
    known_.clear();
    for (const ScannedNode& node : nodes) {
      const auto it = std::lower_bound(labels_.begin(), labels_.end(), node.label);
      if (it == labels_.end() || *it != node.label) continue;
      known_.push_back({&node, static_cast<std::size_t>(it - labels_.begin())});
    }
    for (std::size_t i = 0; i < known_.size(); ++i) {
      const ScannedNode& node = *known_[i].node;
      vote(alone_[known_[i].label].prefix, alone_[known_[i].label].weight);
      for (std::size_t side = 0; side < 2; ++side) {
        const double length = node.size[static_cast<Eigen::Index>(side)];
        if (!(length > 0.0)) continue;
        vote(sides_[2 * known_[i].label + side], similarity_.side_bins(octaves(length)));
      }
      if (!node.position) continue;
      for (std::size_t j = i + 1; j < known_.size(); ++j) {
        const ScannedNode& other = *known_[j].node;
        if (!other.position) continue;
        const auto [low, high] = std::minmax(known_[i].label, known_[j].label);
        vote(pairs_[low * labels_.size() + high],
             similarity_.distance_bins((*node.position - *other.position).norm()));
      }
    }
    double common = 0.0;
    for (Slot* slot : touched_) {
      common += std::min(slot->query, slot->stored);
      slot->stored = 0.0;
    }
    touched_.clear();
    return common;
  }

 private:
  struct Known {
    const ScannedNode* node;
    std::size_t label;  ///< place in `labels_`
  };
  /// A word but for its last part, the bin.
  struct Vote {
    std::uint64_t prefix;
    double weight;
  };
  struct Slot {
    std::uint64_t word = 0;
    double query = 0.0;  ///< > 0 where the slot is taken
    double stored = 0.0;
  };

  Slot& slot_of(std::uint64_t word) {
    std::size_t at = static_cast<std::size_t>(word) & mask_;
    while (slots_[at].query > 0.0 && slots_[at].word != word) at = (at + 1) & mask_;
    return slots_[at];
  }

  void vote(std::uint64_t word, double weight) {
    Slot& slot = slot_of(word);
    if (!(slot.query > 0.0) || !(weight > 0.0)) return;
    if (!(slot.stored > 0.0)) touched_.push_back(&slot);
    slot.stored += weight;
  }

  void vote(const Vote& vote_of_pair, const std::array<SoftBin, 2>& bins) {
    for (const auto& [bin, share] : bins) {
      vote(next_word(vote_of_pair.prefix, bin), vote_of_pair.weight * share);
    }
  }

  /// Logarithms of the few lengths there are are kept.
  double octaves(double length) {
    const double steps = length * steps_per_size_metre;
    if (!(steps < static_cast<double>(octaves_.size()))) {
      return Similarity::octaves(length);
    }
    double& known = octaves_[static_cast<std::size_t>(steps)];
    if (known < 0.0) known = Similarity::octaves(length);
    return known;
  }

  const Similarity& similarity_;
  std::vector<ClassId> labels_;              ///< the query's classes, ascending
  std::vector<Vote> pairs_, sides_, alone_;  ///< by label × label, label × side, label
  std::vector<Slot> slots_;                  ///< open addressing; a power of two
  std::size_t mask_ = 0;
  std::vector<Slot*> touched_;
  std::vector<double> octaves_ = std::vector<double>(512, -1.0);  ///< by steps; < 0 = unknown
  std::vector<Known> known_;  ///< the stored graph's nodes of classes that the query has
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
