// SPDX-License-Identifier: MIT
#include "data_table.hpp"

namespace program {
namespace {

std::string field(const Json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return json_text(value);
  const auto& text = value.get_ref<const std::string&>();
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

template <typename Values>
void append_row(std::string& csv, const Values& values) {
  bool first = true;
  for (const auto& value : values) {
    if (!first) csv += ',';
    csv += field(value);
    first = false;
  }
  csv += '\n';
}

}  // namespace

Json to_json(const DataTable& table) {
  return Json{{"columns", table.columns}, {"rows", table.rows}};
}

std::string to_csv(const DataTable& table) {
  std::string csv;
  append_row(csv, table.columns);
  for (const Json& row : table.rows) append_row(csv, row);
  return csv;
}

}  // namespace program
