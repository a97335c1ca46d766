// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <topobag/bag/query.hpp>
#include <topobag/similarity/sparse_histogram.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The histograms of a bag, turned round: of every word the entries that have it, and how much. A
/// query reads the lists of its own words, and nothing of what it has not in common.
///
/// The scores are those of `jaccard`, to the last bit: what an entry has in common with the query
/// is summed by rising words, as a merge does.
class HistogramIndex {
 public:
  /// Puts a histogram in; returns its slot. O(words).
  std::size_t add(KeyframeId id, const SparseHistogram& histogram) {
    if (free_.empty()) {
      free_.push_back(static_cast<std::uint32_t>(slots_.size()));
      slots_.emplace_back();
    }
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    slots_[slot] = {id, histogram.total(), true};
    for (const SparseHistogram::Entry& entry : histogram.entries()) {
      lists_[entry.word].push_back({slot, entry.weight});
    }
    return slot;
  }

  /// Takes out of `slot` what `add` put there. O(entries that share a word, for each word).
  void remove(std::size_t slot, const SparseHistogram& histogram) {
    for (const SparseHistogram::Entry& entry : histogram.entries()) {
      const auto list = lists_.find(entry.word);
      std::vector<Posting>& postings = list->second;
      const auto posting = std::find_if(postings.begin(), postings.end(),
                                        [&](const Posting& p) { return p.slot == slot; });
      *posting = postings.back();
      postings.pop_back();
      if (postings.empty()) lists_.erase(list);
    }
    slots_[slot].live = false;
    free_.push_back(static_cast<std::uint32_t>(slot));
  }

  void clear() noexcept {
    slots_.clear();
    free_.clear();
    lists_.clear();
  }

  /// The best entries that `admits(KeyframeId)`, by `options.max_results` and
  /// `options.min_similarity`, best first, ties by id. `admits` is asked only of those that would
  /// be among the best. O(entries + words in common + log(max_results) for each of the best so
  /// far).
  template <typename Admits>
  std::vector<Candidate> query(const SparseHistogram& histogram, const QueryOptions& options,
                               const Admits& admits) const {
    std::vector<Candidate> best;  // a heap with the worst on top
    const std::size_t wanted = std::min(options.max_results, slots_.size());
    if (wanted == 0) return best;
    const std::vector<double> common = common_mass(histogram);
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      const Slot& slot = slots_[i];
      if (!slot.live) continue;
      const Candidate candidate{slot.id, jaccard_index(common[i], histogram.total(), slot.total)};
      if (!(candidate.similarity >= options.min_similarity)) continue;
      const bool full = best.size() == wanted;
      if ((full && !(candidate < best.front())) || !admits(slot.id)) continue;
      if (full) {
        std::pop_heap(best.begin(), best.end());
        best.pop_back();
      }
      best.push_back(candidate);
      std::push_heap(best.begin(), best.end());
    }
    std::sort_heap(best.begin(), best.end());
    return best;
  }

 private:
  struct Slot {
    KeyframeId id{};
    double total = 0.0;
    bool live = false;
  };
  struct Posting {
    std::uint32_t slot;
    double weight;
  };

  /// Of each slot, Σ min of the weights of the common words.
  std::vector<double> common_mass(const SparseHistogram& histogram) const {
    std::vector<double> common(slots_.size(), 0.0);
    for (const SparseHistogram::Entry& entry : histogram.entries()) {
      const auto list = lists_.find(entry.word);
      if (list == lists_.end()) continue;
      for (const Posting& posting : list->second) {
        common[posting.slot] += std::min(entry.weight, posting.weight);
      }
    }
    return common;
  }

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;  ///< slots that hold nothing
  std::unordered_map<std::uint64_t, std::vector<Posting>> lists_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
