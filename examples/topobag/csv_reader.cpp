// SPDX-License-Identifier: MIT
#include "csv_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <system_error>

#include <topobag/bag/atomic_file.hpp>
#include <topobag/types/stamp.hpp>

namespace program {

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> number = topobag::parse_number(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string read_file(const std::string& path) {
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) {
    throw InputError(path, "it is a folder; name a file in it");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file && errno != ENOENT && errno != 0) {
    throw InputError(path, "the file cannot be opened: " + std::generic_category().message(errno));
  }
  if (!file) {
    throw InputError(path, "the file cannot be opened; check the path" + home_hint(path));
  }
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw InputError(path, "the file cannot be read");
  return text;
}

void write_file(const std::string& path, const std::string& text) {
  namespace fs = std::filesystem;
  if (fs::exists(path) && !fs::is_regular_file(path) && !fs::is_directory(path)) {
    std::ofstream file(path, std::ios::binary);
    file << text << std::flush;
    if (!file) {
      throw InputError(path, "it cannot be written: " + std::generic_category().message(errno));
    }
    return;
  }
  write_files({{path, text}});
}

void write_files(const std::vector<std::pair<std::string, std::string>>& files) {
  std::deque<topobag::AtomicFile> written;
  for (const auto& [path, text] : files) {
    topobag::AtomicFile& file = written.emplace_back(path);
    std::ostream stream(file.buffer());
    stream << text << std::flush;
    if (!stream) file.fail();
  }
  for (topobag::AtomicFile& file : written) file.commit();
}

namespace {

/// The fields of a row between tabs alone, which blanks in a name do not part and which may be
/// empty. None where it has no tab, or a comma.
void split_at_tabs(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  if (line.find('\t') == line.npos || line.find(',') != line.npos) return;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find('\t', begin), line.size());
    fields.push_back(topobag::trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
}

}  // namespace

CsvReader::CsvReader(const std::string& path) : stream_(read_file(path)), lines_(stream_, path) {
  if (!read_line()) throw InputError(path, "the file is empty; a header row is needed");
  header_.assign(fields_.begin(), fields_.end());
  if (header_.size() == 1 && header_.front().find(';') != std::string::npos) {
    throw error("columns are separated by commas, not semicolons, and decimals have a point");
  }
  for (auto it = header_.begin(); it != header_.end(); ++it) {
    if (parse_number(*it)) {
      throw error("'" + *it + "' stands where a header row names a column");
    }
    if (std::find(header_.begin(), it, *it) != it) {
      throw error("the header names column '" + *it + "' twice");
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
  const std::size_t most = 12;
  std::string names;
  for (std::size_t i = 0; i < std::min(most, header_.size()); ++i) names += " '" + header_[i] + "'";
  if (header_.size() > most) names += " and " + std::to_string(header_.size() - most) + " more";
  throw error("there is no column '" + std::string(name) + "'; the header names" + names);
}

bool CsvReader::next() {
  if (!read_line()) return false;
  if (std::equal(fields_.begin(), fields_.end(), header_.begin(), header_.end())) {
    throw error("the header stands here again; a file holds one table");
  }
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
  const std::optional<std::int64_t> number = topobag::parse_whole(fields_[column]);
  if (!number) throw bad_field(column, "an integer");
  return *number;
}

double CsvReader::seconds(std::size_t column) const {
  const double stamp = number(column);
  located([&] { topobag::require_seconds(stamp); });
  return stamp;
}

/// Splits the next line.
bool CsvReader::read_line() {
  std::string_view line;
  if (!lines_.next(line)) return false;
  if (line.find('"') != std::string_view::npos) {
    throw error("a field stands in quotes; write fields without, and none with a comma in it");
  }
  split_at_tabs(line, fields_);
  const bool parted = !header_.empty() && fields_.size() == header_.size();
  if (!parted) topobag::TextLines::split(line, fields_);
  return true;
}

topobag::Error CsvReader::bad_field(std::size_t column, const char* wanted) const {
  return error("column '" + header_[column] + "' holds '" + std::string(fields_[column]) +
               "', which is not " + wanted);
}

}  // namespace program
