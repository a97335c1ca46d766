// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input_error.hpp"

namespace program {

/// Parses the whole of `text` as a finite number; nothing when it is not one.
std::optional<double> parse_number(std::string_view text);

/// Reads a whole file. Throws InputError.
std::string read_file(const std::string& path);

/// Writes a whole file. Throws InputError.
void write_file(const std::string& path, const std::string& text);

/// A comma-separated file with a header row, read row by row.
///
/// Blanks around fields and empty lines are ignored, quoted fields refused. Everything that is
/// wrong throws InputError with the file and the line.
///
///     CsvReader csv("frames.csv");
///     const std::size_t time = csv.column("timestamp");
///     while (csv.next()) use(csv.number(time));
class CsvReader {
 public:
  /// Reads the file and its header row.
  explicit CsvReader(const std::string& path);
  CsvReader(const CsvReader&) = delete;  // the fields point into the text
  CsvReader& operator=(const CsvReader&) = delete;

  /// The position of a column; throws when the header does not name it.
  std::size_t column(std::string_view name) const;
  std::optional<std::size_t> find_column(std::string_view name) const;

  /// Moves to the next row; false after the last.
  bool next();

  /// A field of the current row, valid as long as the reader.
  std::string_view text(std::size_t column) const { return fields_[column]; }

  /// A finite number.
  double number(std::size_t column) const;

  std::int64_t integer(std::size_t column) const;

  /// An error at the current row.
  InputError error(const std::string& sentence) const { return {path_, line_, sentence}; }

 private:
  bool read_line();
  InputError bad_field(std::size_t column, const char* wanted) const;

  std::string path_;
  std::string text_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  std::vector<std::string_view> header_;
  std::vector<std::string_view> fields_;
};

}  // namespace program
