// SPDX-License-Identifier: MIT
#include "number_list.hpp"

#include <optional>
#include <sstream>

#include "csv_reader.hpp"

namespace program {

NumberList::NumberList(const std::string& option, const std::string& text, const char* form)
    : place_(option + ' ' + text), form_(form) {
  std::istringstream fields(text);
  for (std::string field; std::getline(fields, field, ',');) {
    const std::optional<double> number = parse_number(field);
    if (!number) throw error("'" + std::string(topobag::trimmed(field)) + "' is not a number");
    numbers_.push_back(*number);
  }
}

}  // namespace program
