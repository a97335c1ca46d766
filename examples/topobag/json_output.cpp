// SPDX-License-Identifier: MIT
#include "json_output.hpp"

#include <algorithm>
#include <cstddef>

#include "input_error.hpp"

namespace program {
namespace {

std::string value_text(const Json& value) {
  if (value.is_null()) return "undefined";
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return json_text(value);
  std::string text;
  for (const Json& item : value) text += (text.empty() ? "" : " .. ") + value_text(item);
  return text;
}

void append_lines(const Json& object, std::size_t indent, std::string& text) {
  std::size_t width = 0;
  for (const auto& item : object.items()) width = std::max(width, item.key().size());
  for (const auto& item : object.items()) {
    text += std::string(indent, ' ') + item.key();
    if (item.value().is_object()) {
      text += '\n';
      append_lines(item.value(), indent + 2, text);
    } else {
      text += std::string(width + 2 - item.key().size(), ' ') + value_text(item.value()) + '\n';
    }
  }
}

}  // namespace

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string json_complaint(const std::exception& error) {
  const std::string said = error.what();
  const std::size_t numbering =
      said.rfind("[json.exception.", 0) == 0 ? said.find("] ") : said.npos;
  return numbering == said.npos ? said : said.substr(numbering + 2);
}

Json parsed_json(const std::string& text) {
  const std::string start = text.substr(0, 2);
  if (start == "\xFF\xFE" || start == "\xFE\xFF") {
    throw InputError("this is UTF-16: save it as UTF-8");
  }
  if (text.find_first_not_of(" \t\r\n") == text.npos) throw InputError("the file is empty");
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    if (error.byte > text.size()) {
      throw InputError("the JSON ends in the middle: the file is cut off; write it anew");
    }
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(error.byte);
    const auto line = 1 + std::count(text.begin(), end, '\n');
    throw InputError("line " + std::to_string(line) + " is no JSON, byte " +
                     std::to_string(error.byte) + " of the file");
  }
}

Json versioned(const Json& json) {
  Json document{{"schema", json_schema}};
  document.update(json);
  return document;
}

std::string output_text(const Json& result, bool as_json) {
  if (as_json) return json_text(versioned(result), 2) + '\n';
  std::string text;
  append_lines(result, 0, text);
  return text;
}

}  // namespace program
