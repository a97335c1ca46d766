// SPDX-License-Identifier: MIT
#include "csv_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

namespace program {
namespace {

std::string_view trimmed(std::string_view text) {
  const char* const blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Parses all of `text`; nothing when it is not a `Number` or does not fit in one.
template <typename Number>
std::optional<Number> parse(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return number;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> number = parse<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path, "the file cannot be opened; check the path");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw InputError(path, "the file cannot be read");
  return text;
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) throw InputError(path, "the file cannot be written; check the folder and its rights");
}

CsvReader::CsvReader(const std::string& path) : path_(path), text_(read_file(path)) {
  const std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.compare(0, byte_order_mark.size(), byte_order_mark) == 0) {
    position_ = byte_order_mark.size();
  }
  if (!read_line()) throw InputError(path_, "the file is empty; a header row is needed");
  header_ = fields_;
  for (auto it = header_.begin(); it != header_.end(); ++it) {
    if (std::find(header_.begin(), it, *it) != it) {
      throw error("the header names column '" + std::string(*it) + "' twice");
    }
  }
}

std::optional<std::size_t> CsvReader::find_column(std::string_view name) const {
  const auto it = std::find(header_.begin(), header_.end(), name);
  if (it == header_.end()) return std::nullopt;
  return static_cast<std::size_t>(it - header_.begin());
}

std::size_t CsvReader::column(std::string_view name) const {
  if (const std::optional<std::size_t> found = find_column(name)) return *found;
  std::string names;
  for (const std::string_view column : header_) names += " '" + std::string(column) + "'";
  throw error("there is no column '" + std::string(name) + "'; the header names" + names);
}

bool CsvReader::next() {
  if (!read_line()) return false;
  if (fields_.size() != header_.size()) {
    throw error("the row has " + std::to_string(fields_.size()) + " fields, the header " +
                std::to_string(header_.size()));
  }
  return true;
}

double CsvReader::number(std::size_t column) const {
  const std::optional<double> number = parse_number(fields_[column]);
  if (!number) throw bad_field(column, "a finite number");
  return *number;
}

std::int64_t CsvReader::integer(std::size_t column) const {
  const std::optional<std::int64_t> number = parse<std::int64_t>(fields_[column]);
  if (!number) throw bad_field(column, "an integer");
  return *number;
}

/// Splits the next line that is not blank.
bool CsvReader::read_line() {
  std::string_view line;
  while (line.empty()) {
    if (position_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    line = trimmed(std::string_view(text_).substr(position_, end - position_));
    position_ = end + 1;
    ++line_;
  }
  if (line.find('"') != std::string_view::npos) throw error("quoted fields are not supported");
  fields_.clear();
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields_.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return true;
}

InputError CsvReader::bad_field(std::size_t column, const char* wanted) const {
  return error("column '" + std::string(header_[column]) + "' holds '" +
               std::string(fields_[column]) + "', which is not " + wanted);
}

}  // namespace program
