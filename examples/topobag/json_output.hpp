// SPDX-License-Identifier: MIT
#pragma once

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

/// The result as JSON, or for reading: a line per value, nested values indented.
std::string output_text(const Json& result, bool as_json);

}  // namespace program
