// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// Whether `text` is UTF-8, of which ASCII is a part: no stray byte, no surrogate, nothing longer
/// than it need be.
inline bool is_utf8(std::string_view text) noexcept {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned first = byte(i);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    const bool leads = first < 0x80 || (first >= 0xC2 && first <= 0xF4);
    if (!leads || length > text.size() - i) return false;
    for (std::size_t k = 1; k < length; ++k) {
      if ((byte(i + k) & 0xC0U) != 0x80U) return false;
    }
    const unsigned second = length > 1 ? byte(i + 1) : 0;
    const bool too_long = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool no_character = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
    if (too_long || no_character) return false;
    i += length;
  }
  return true;
}

/// Throws InvalidValue unless `text` is UTF-8: what every name is held to, so that whatever reads
/// the map later can show it.
/// @param what  begins the sentence: "the session's name"
inline void require_utf8(std::string_view text, const char* what) {
  if (!is_utf8(text)) throw InvalidValue(std::string(what) + " is not UTF-8");
}

}  // namespace v0
}  // namespace topobag
