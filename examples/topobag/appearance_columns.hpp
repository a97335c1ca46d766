// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <topobag/types/appearance.hpp>

#include "csv_reader.hpp"

namespace program {

/// The columns of a node table that say what objects look like: `appearance`, the name of the
/// method that described them, one in all of the table, and `a0`, `a1`, …, its numbers, -128 to
/// 127. Both may be missing; a row whose `appearance` is empty has none.
class AppearanceColumns {
 public:
  /// Throws InputError for one of the two without the other, or too many numbers.
  explicit AppearanceColumns(const CsvReader& csv);

  /// What the current row says; unknown where that is nothing. Throws topobag::Error with the line.
  topobag::Appearance read();

  /// The method's name; empty where no row had one.
  const std::string& name() const noexcept { return name_; }

  /// Writes the names of the columns, each behind a comma.
  static void write_header(std::ostream& out, std::size_t length);

  /// Writes a row's fields for `length` numbers, each behind a comma.
  static void write(std::ostream& out, const topobag::Appearance& appearance,
                    const std::string& name, std::size_t length);

 private:
  const CsvReader& csv_;
  std::optional<std::size_t> name_column_;
  std::vector<std::size_t> numbers_;  ///< columns
  std::string name_;
};

}  // namespace program
