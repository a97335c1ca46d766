// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace program {

using Json = nlohmann::ordered_json;

/// A value, or null where it is undefined.
template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

/// JSON as text, in one line or indented; a byte that is no UTF-8, as in the name of a file,
/// becomes U+FFFD.
std::string json_text(const Json& json, int indent = -1);

/// What was wrong with a JSON text or a value of it, without the parser's own numbering.
std::string json_complaint(const std::exception& error);

/// The JSON of a file's text. Throws InputError, without the file's name, for what is none, and
/// says what it is instead: nothing, cut off, in UTF-16.
Json parsed_json(const std::string& text);

/// The version of the shape of all JSON that the program writes, which examples/docs describes. It
/// rises when a key goes or changes its meaning, not when one is added.
inline constexpr int json_schema = 1;

/// The object with its version, which comes first.
Json versioned(const Json& json);

/// The result as JSON, versioned, or for reading: a line per value, nested values indented.
std::string output_text(const Json& result, bool as_json);

}  // namespace program
