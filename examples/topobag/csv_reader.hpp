// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <topobag/evaluation/text_lines.hpp>

#include "input_error.hpp"

namespace program {

/// Parses the whole of `text` as a finite number; nothing when it is not one.
std::optional<double> parse_number(std::string_view text);

/// Reads a whole file. Throws InputError.
std::string read_file(const std::string& path);

/// Writes a whole file: complete under its name when this returns, or, after an error with the
/// system's reason, as it was. What is no regular file, such as /dev/stdout, is written as it
/// comes. Throws topobag::Error.
void write_file(const std::string& path, const std::string& text);

/// The same of files that belong together, each a path and its text: all are on the disk before the
/// first one takes its name.
void write_files(const std::vector<std::pair<std::string, std::string>>& files);

/// A comma-separated file with a header row, read row by row as topobag::TextLines reads.
///
/// Quoted fields are refused. Everything that is wrong throws topobag::Error with the file and the
/// line.
///
///     CsvReader csv("frames.csv");
///     const std::size_t time = csv.column("timestamp");
///     while (csv.next()) use(csv.number(time));
class CsvReader {
 public:
  /// Reads the file and its header row.
  explicit CsvReader(const std::string& path);
  CsvReader(const CsvReader&) = delete;  // the lines point into the text
  CsvReader& operator=(const CsvReader&) = delete;

  /// The position of a column; throws when the header does not name it.
  std::size_t column(std::string_view name) const;
  std::optional<std::size_t> find_column(std::string_view name) const;

  /// Moves to the next row; false after the last.
  bool next();

  /// A field of the current row, valid until the next one.
  std::string_view text(std::size_t column) const { return fields_[column]; }

  /// A finite number.
  double number(std::size_t column) const;

  std::int64_t integer(std::size_t column) const;

  /// A time.
  double seconds(std::size_t column) const;

  /// An error at the current row.
  topobag::Error error(const std::string& sentence) const { return lines_.error(sentence); }

  /// What `call()` returns; an error of it gets file and line.
  template <typename Call>
  auto located(const Call& call) const {
    return lines_.located(call);
  }

 private:
  bool read_line();
  topobag::Error bad_field(std::size_t column, const char* wanted) const;

  std::istringstream stream_;
  topobag::TextLines lines_;
  std::vector<std::string> header_;
  std::vector<std::string_view> fields_;
};

}  // namespace program
