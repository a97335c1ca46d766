// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>

#include "csv_reader.hpp"

namespace program {

/// Checks that an option is a finite number in [min, max]; CLI::Range lets NaN pass.
inline CLI::Validator number_within(double min,
                                    double max = std::numeric_limits<double>::infinity()) {
  std::ostringstream range;
  range << '[' << min << ", " << max << (max < std::numeric_limits<double>::infinity() ? ']' : ')');
  return {[min, max, range = range.str()](std::string& text) {
            const std::optional<double> number = parse_number(text);
            return number && *number >= min && *number <= max
                       ? std::string()
                       : "'" + text + "' is not a number in " + range;
          },
          range.str()};
}

}  // namespace program
