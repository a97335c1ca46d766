// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Takes apart what a `BitWriter` packed. Every call throws FormatError rather than read beyond the
/// end.
class BitReader {
 public:
  BitReader(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  std::uint64_t bits_left() const noexcept { return std::uint64_t{8} * (size_ - at_) + filled_; }

  /// The next `width` <= 64 bits.
  std::uint64_t get(unsigned width) {
    if (width > bits_left()) throw FormatError("the data end too early: they are cut off");
    if (width > 32) {
      const std::uint64_t low = get(32);
      return get(width - 32) << 32 | low;
    }
    for (; filled_ < width; filled_ += 8) {
      pending_ |= static_cast<std::uint64_t>(data_[at_++]) << filled_;
    }
    const std::uint64_t value = pending_ & ((std::uint64_t{1} << width) - 1);
    pending_ >>= width;
    filled_ -= width;
    return value;
  }

  std::uint64_t get_number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 60; shift += 4) {
      const std::uint64_t group = get(5);
      value |= (group & 15) << shift;
      if (group < 16) return value;
    }
    throw FormatError("the data hold a number that is too large: they are damaged");
  }

  std::int64_t get_signed() {
    const std::uint64_t folded = get_number();
    const auto magnitude = static_cast<std::int64_t>(folded >> 1);
    return (folded & 1) != 0 ? -1 - magnitude : magnitude;
  }

  /// How many of something follow, each at least one bit long: checked before anything is made.
  std::size_t get_count() {
    const std::uint64_t count = get_number();
    if (count > bits_left()) {
      throw FormatError("the data announce more than they hold: they are damaged or cut off");
    }
    return static_cast<std::size_t>(count);
  }

  /// Throws FormatError unless all is read but the zeros that fill the last byte.
  void finish() {
    if (bits_left() >= 8 || get(static_cast<unsigned>(bits_left())) != 0) {
      throw FormatError("the data go on after their end: they are damaged");
    }
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;         ///< the next byte
  std::uint64_t pending_ = 0;  ///< bits of those before it that are not taken yet
  unsigned filled_ = 0;        ///< how many, < 8
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
