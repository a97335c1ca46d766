// SPDX-License-Identifier: MIT
#include "appearance_columns.hpp"

#include <cstdint>
#include <limits>
#include <ostream>

namespace program {
namespace {

std::string number_column(std::size_t i) { return "a" + std::to_string(i); }

}  // namespace

AppearanceColumns::AppearanceColumns(const CsvReader& csv)
    : csv_(csv), name_column_(csv.find_column("appearance")) {
  while (const auto column = csv.find_column(number_column(numbers_.size()))) {
    numbers_.push_back(*column);
  }
  if (name_column_.has_value() == numbers_.empty()) {
    throw csv.error(
        "columns a0, a1, … say what an object looks like, and column appearance which method gave "
        "them: both are needed, or neither");
  }
  if (numbers_.size() > topobag::AppearanceKind::max_length) {
    throw csv.error("an appearance holds up to " +
                    std::to_string(topobag::AppearanceKind::max_length) + " numbers, a0 to a63");
  }
}

topobag::Appearance AppearanceColumns::read() {
  if (!name_column_ || csv_.text(*name_column_).empty()) return {};
  if (name_.empty()) name_ = csv_.text(*name_column_);
  if (csv_.text(*name_column_) != name_) {
    throw csv_.error("appearance '" + std::string(csv_.text(*name_column_)) +
                     "' is another one than '" + name_ +
                     "' above: describe all objects by one method");
  }
  topobag::Appearance::Bytes bytes{};
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const std::int64_t number = csv_.integer(numbers_[i]);
    if (number < std::numeric_limits<std::int8_t>::min() ||
        number > std::numeric_limits<std::int8_t>::max()) {
      throw csv_.error(number_column(i) + " has to lie in [-128, 127]");
    }
    bytes[i] = static_cast<std::int8_t>(number);
  }
  return csv_.located(
      [&] { return topobag::Appearance(topobag::AppearanceKind(name_, numbers_.size()), bytes); });
}

void AppearanceColumns::write_header(std::ostream& out, std::size_t length) {
  if (length == 0) return;
  out << ",appearance";
  for (std::size_t i = 0; i < length; ++i) out << ',' << number_column(i);
}

void AppearanceColumns::write(std::ostream& out, const topobag::Appearance& appearance,
                              const std::string& name, std::size_t length) {
  if (length == 0) return;
  out << ',';
  if (appearance.known()) out << name;
  for (std::size_t i = 0; i < length; ++i) {
    out << ',';
    if (appearance.known()) out << int{appearance.bytes()[i]};
  }
}

}  // namespace program
