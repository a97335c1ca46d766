// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// One property of all nodes (or views, or edges), as integers.
using Column = std::vector<std::int64_t>;

/// The least and greatest value that a column may hold.
struct ColumnRange {
  std::int64_t low;
  std::int64_t high;
};

/// Bits a value takes at least in a column that vouches for its length: what is made of the data is
/// never out of proportion to them.
inline constexpr unsigned vouching_width = 7;

/// `x` in units of 1 / `steps`, kept within the range. Halves go away from zero.
inline std::int64_t quantized(double x, double steps, ColumnRange range) {
  const double scaled =
      std::clamp(x * steps, static_cast<double>(range.low), static_cast<double>(range.high));
  return std::llround(scaled);
}

/// The least number of bits that hold `value`.
inline unsigned bit_width(std::uint64_t value) noexcept {
  unsigned width = 0;
  for (; value != 0; value >>= 1) ++width;
  return width;
}

/// Writes how far each value lies above the smallest, in as many bits as the largest needs: equal
/// values cost nothing beyond the header of some 2 bytes.
/// @param min_width  bits a value takes at least
inline void put_column(BitWriter& writer, const Column& values, unsigned min_width = 0) {
  if (values.empty()) return;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const unsigned width = std::max(min_width, bit_width(static_cast<std::uint64_t>(*high - *low)));
  writer.put(width, 6);
  writer.put_signed(*low);
  for (const std::int64_t value : values) {
    writer.put(static_cast<std::uint64_t>(value - *low), width);
  }
}

/// Reads `count` values. Throws FormatError for one outside `range`, and before it makes room when
/// there are fewer.
inline Column get_column(BitReader& reader, std::size_t count, ColumnRange range,
                         unsigned min_width = 0) {
  if (count == 0) return {};
  const auto width = static_cast<unsigned>(reader.get(6));
  const std::int64_t low = reader.get_signed();
  const auto out_of_range = [] {
    return FormatError("the data hold a number out of range: they are damaged");
  };
  if (width < min_width || width > 32 || low < range.low || low > range.high) throw out_of_range();
  if (width > 0 && count > reader.bits_left() / width) {
    throw FormatError("the data end too early: they are cut off");
  }
  Column values(count);
  for (std::int64_t& value : values) {
    value = low + static_cast<std::int64_t>(reader.get(width));
    if (value > range.high) throw out_of_range();
  }
  return values;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
