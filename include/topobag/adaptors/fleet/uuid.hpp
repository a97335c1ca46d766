// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// A number of 128 bits that nobody else draws: of a robot, of one of its sessions.
using Uuid = std::array<std::uint8_t, 16>;

/// Drawn from the machine's entropy.
inline Uuid random_uuid() {
  std::random_device entropy;
  Uuid uuid;
  for (std::uint8_t& byte : uuid) byte = static_cast<std::uint8_t>(entropy());
  uuid[6] = static_cast<std::uint8_t>((uuid[6] & 0x0F) | 0x40);  // RFC 9562, version 4
  uuid[8] = static_cast<std::uint8_t>((uuid[8] & 0x3F) | 0x80);
  return uuid;
}

/// As in "123e4567-e89b-42d3-a456-426614174000".
inline std::string to_text(const Uuid& uuid) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < uuid.size(); ++i) {
    if (i == 4 || i == 6 || i == 8 || i == 10) text += '-';
    text += digits[uuid[i] >> 4];
    text += digits[uuid[i] & 0x0F];
  }
  return text;
}

/// Of 32 hexadecimal digits, hyphens passed over. Throws InvalidValue for anything else.
inline Uuid parse_uuid(const std::string& text) {
  Uuid uuid{};
  std::size_t digits = 0;
  bool sound = true;
  for (const char letter : text) {
    if (letter == '-') continue;
    const std::string all = "0123456789abcdef0123456789ABCDEF";
    const std::size_t at = all.find(letter);
    sound = sound && at != std::string::npos && digits < 2 * uuid.size();
    if (!sound) break;
    std::uint8_t& byte = uuid[digits++ / 2];
    byte = static_cast<std::uint8_t>(std::size_t{byte} << 4 | (at % 16));
  }
  if (sound && digits == 2 * uuid.size()) return uuid;
  throw InvalidValue("'" + text +
                     "' is no UUID: 32 hexadecimal digits, as in "
                     "123e4567-e89b-42d3-a456-426614174000");
}

}  // namespace v0
}  // namespace topobag
