// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The finaliser of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014): a bijection that scatters well.
constexpr std::uint64_t scatter(std::uint64_t x) noexcept {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

constexpr std::uint64_t as_bits(ClassId label) noexcept {
  return static_cast<std::uint32_t>(value(label));
}
constexpr std::uint64_t as_bits(std::uint64_t bits) noexcept { return bits; }

/// What becomes of a word when the next part of its sequence is taken in.
template <typename Part>
constexpr std::uint64_t next_word(std::uint64_t word, Part part) noexcept {
  return scatter(word ^ as_bits(part));
}

/// What a word of `size` parts is before the rest of them is taken in by `next_word`.
template <std::size_t size, typename... Parts>
constexpr std::uint64_t word_prefix(const Parts&... parts) noexcept {
  static_assert(sizeof...(parts) <= size);
  std::uint64_t word = size;
  ((word = next_word(word, parts)), ...);
  return word;
}

/// The word of a sequence of labels, bins and words. Two different sequences share one with
/// probability 2⁻⁶⁴. The same on every machine.
template <typename... Parts>
constexpr std::uint64_t histogram_word(const Parts&... parts) noexcept {
  return word_prefix<sizeof...(parts)>(parts...);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
