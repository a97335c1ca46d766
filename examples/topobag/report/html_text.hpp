// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace program {

/// Text with the characters that HTML and SVG give a meaning replaced, in content and attributes.
std::string escaped(std::string_view text);

/// JSON for a script element, which no text in it can end.
std::string script_text(std::string_view json);

/// A number with a fixed count of decimals.
std::string fixed_text(double value, int decimals);

/// A number with up to four digits that count, without trailing zeros.
std::string short_text(double value);

/// Raw bytes as base64 (RFC 4648, padded).
std::string base64(std::string_view bytes);

}  // namespace program
