// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string_view>
#include <system_error>

#include <topobag/assert.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// `text` without the blanks around it.
inline std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The number that all of `text` is, but for blanks around it and a plus before it, whatever the
/// locale; nothing when it is not one, or does not fit into a `Number`. For a floating-point
/// number `nan` and `inf` are numbers.
template <typename Number = double>
std::optional<Number> parse_number(std::string_view text) noexcept {
  text = trimmed(text);
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  if (plus) text.remove_prefix(1);
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, number);
  if (status != std::errc{} || stop != end) return std::nullopt;
  return number;
}

/// The whole number that all of `text` is, be it written as a floating-point number: `62.0` is 62.
/// Nothing for anything else.
inline std::optional<std::int64_t> parse_whole(std::string_view text) noexcept {
  if (const auto whole = parse_number<std::int64_t>(text)) return whole;
  constexpr double exact = 9007199254740992.0;  // up to which a double holds every whole number
  const auto number = parse_number(text);
  if (!number || !(std::abs(*number) <= exact) || *number != std::floor(*number)) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(*number);
}

/// Writes the shortest text that reads back as the same number, whatever the locale.
inline void write_number(std::ostream& stream, double number) {
  char text[32];
  const auto [end, status] = std::to_chars(text, text + sizeof text, number);
  TOPOBAG_ASSERT(status == std::errc{});
  stream.write(text, end - text);
}

}  // namespace v0
}  // namespace topobag
