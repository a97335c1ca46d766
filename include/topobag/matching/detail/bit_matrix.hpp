// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/platform.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

using BitWord = std::uint64_t;

/// Rows of bits, all of one length: an adjacency matrix, or a stack of vertex sets.
class BitMatrix {
 public:
  BitMatrix(std::size_t rows, std::size_t columns)
      : words_((columns + 63) / 64), bits_(rows * words_, 0) {}

  std::size_t words() const noexcept { return words_; }
  BitWord* row(std::size_t i) noexcept { return bits_.data() + i * words_; }
  const BitWord* row(std::size_t i) const noexcept { return bits_.data() + i * words_; }

  void set(std::size_t i, std::size_t j) noexcept { set_if(true, i, j); }
  /// Without a branch.
  void set_if(bool on, std::size_t i, std::size_t j) noexcept {
    row(i)[j / 64] |= BitWord{on} << (j % 64);
  }
  void reset(std::size_t i, std::size_t j) noexcept { row(i)[j / 64] &= ~(BitWord{1} << (j % 64)); }
  bool test(std::size_t i, std::size_t j) const noexcept {
    return (row(i)[j / 64] >> (j % 64)) & 1U;
  }

 private:
  std::size_t words_;
  std::vector<BitWord> bits_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
