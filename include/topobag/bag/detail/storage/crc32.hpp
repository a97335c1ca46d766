// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

constexpr std::array<std::uint32_t, 256> make_crc32_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t remainder = i;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder & 1) != 0 ? remainder >> 1 ^ 0xEDB88320 : remainder >> 1;
    }
    table[i] = remainder;
  }
  return table;
}

/// CRC-32 (ISO 3309) of `size` bytes that follow those of `before`. Finds every error of up to 32
/// bits in a row.
inline std::uint32_t crc32(const std::uint8_t* data, std::size_t size, std::uint32_t before = 0) {
  static constexpr std::array<std::uint32_t, 256> table = make_crc32_table();
  std::uint32_t remainder = ~before;
  for (std::size_t i = 0; i < size; ++i) {
    remainder = table[(remainder ^ data[i]) & 0xFF] ^ remainder >> 8;
  }
  return ~remainder;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
