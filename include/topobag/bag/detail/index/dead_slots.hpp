// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Which entries of a segment are gone: a bit for each.
class DeadSlots {
 public:
  DeadSlots() = default;
  explicit DeadSlots(std::size_t slots) : words_((slots + 63) / 64, 0) {}

  bool contains(std::size_t slot) const noexcept {
    return (words_[slot / 64] >> (slot % 64) & 1U) != 0;
  }
  /// Precondition: it is not there.
  void insert(std::size_t slot) noexcept {
    words_[slot / 64] |= std::uint64_t{1} << (slot % 64);
    ++count_;
  }
  std::size_t size() const noexcept { return count_; }
  std::size_t bytes() const noexcept { return words_.capacity() * sizeof(std::uint64_t); }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t count_ = 0;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
