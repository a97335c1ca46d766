// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <topobag/assert.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Packs unsigned numbers of any width, lowest bit first, so that whole bytes are little-endian on
/// every machine.
class BitWriter {
 public:
  /// The low `width` bits of `value`, `width` <= 64. Precondition: nothing stands above them.
  void put(std::uint64_t value, unsigned width) {
    TOPOBAG_ASSERT(width == 64 || value >> width == 0);
    if (width > 32) {
      put(value & 0xFFFFFFFF, 32);
      value >>= 32;
      width -= 32;
    }
    pending_ |= value << filled_;
    for (filled_ += width; filled_ >= 8; filled_ -= 8) {
      bytes_.push_back(static_cast<std::uint8_t>(pending_));
      pending_ >>= 8;
    }
  }

  /// A number of any size, four bits at a time, each with one that says whether more follow.
  void put_number(std::uint64_t value) {
    for (; value > 15; value >>= 4) put((value & 15) | 16, 5);
    put(value, 5);
  }

  /// A number of either sign, small where it is near zero.
  void put_signed(std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    put_number(value < 0 ? ~(bits << 1) : bits << 1);
  }

  /// All that was put, the last byte filled up with zeros.
  std::vector<std::uint8_t> take() {
    if (filled_ > 0) bytes_.push_back(static_cast<std::uint8_t>(pending_));
    return std::move(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint64_t pending_ = 0;  ///< bits that do not fill a byte yet
  unsigned filled_ = 0;        ///< how many, < 8
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
