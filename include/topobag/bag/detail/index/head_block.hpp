// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/bag/entry_info.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The newest entries, in the order in which they came, before they become a segment.
///
/// Only ever appended to. A reader knows from its snapshot how many there were and reads no
/// further, so the writer never touches what a reader may be looking at.
class HeadBlock {
 public:
  static constexpr std::size_t capacity = 128;

  struct Entry {
    KeyframeId id{};
    EntryInfo info;
    std::vector<std::uint8_t> graph;  ///< encoded, and `scan_margin` bytes more
    float total = 0.0F;               ///< sum of the weights of its histogram
  };

  HeadBlock() : entries_(capacity) {}
  /// The first `size` entries of another, which its writer may be appending to.
  HeadBlock(const HeadBlock& other, std::size_t size) : HeadBlock() {
    std::copy_n(other.entries_.begin(), size, entries_.begin());
  }
  HeadBlock(const HeadBlock&) = delete;
  HeadBlock& operator=(const HeadBlock&) = delete;

  const Entry& operator[](std::size_t i) const noexcept { return entries_[i]; }
  Entry& operator[](std::size_t i) noexcept { return entries_[i]; }

 private:
  std::vector<Entry> entries_;  ///< as long from the start as it ever is
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
