// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>

#include "csv_reader.hpp"

namespace program {

/// What to do about a number with a comma, to be put behind a complaint; empty without.
inline std::string decimals_hint(const std::string& text) {
  return text.find(',') == std::string::npos ? "" : "; decimals have a point";
}

/// Checks that an option is a finite number that lies where `inside` says and `range` shows.
template <typename Inside>
CLI::Validator finite_number(const std::string& range, const Inside& inside) {
  return {[range, inside](std::string& text) {
            const std::optional<double> number = parse_number(text);
            return number && inside(*number)
                       ? std::string()
                       : "'" + text + "' is not a number in " + range + decimals_hint(text);
          },
          range};
}

/// A number in [min, max]; CLI::Range lets NaN pass.
inline CLI::Validator number_within(double min,
                                    double max = std::numeric_limits<double>::infinity()) {
  std::ostringstream range;
  range << '[' << min << ", " << max << (max < std::numeric_limits<double>::infinity() ? ']' : ')');
  return finite_number(range.str(), [=](double number) { return number >= min && number <= max; });
}

/// A number above 0; CLI::PositiveNumber lets NaN pass.
inline CLI::Validator number_above_zero() {
  return finite_number("(0, inf)", [](double number) { return number > 0.0; });
}

/// A whole number from `min` on; CLI11 reads -1 as the largest number without a sign.
inline CLI::Validator whole_number_from(std::int64_t min) {
  const std::string range = "[" + std::to_string(min) + ", inf)";
  return {[range, min](std::string& text) {
            const std::optional<std::int64_t> number = topobag::parse_whole(text);
            return number && *number >= min ? std::string()
                                            : "'" + text + "' is not a whole number in " + range;
          },
          range};
}

/// The idx of a frame in its table.
inline CLI::Validator frame_number() {
  return {[](std::string& text) {
            return topobag::parse_whole(text)
                       ? std::string()
                       : "'" + text + "' is not the idx of a frame, a whole number";
          },
          "idx"};
}

/// Any number; without a check NaN would be one.
inline CLI::Validator any_number() {
  return finite_number("(-inf, inf)", [](double) { return true; });
}

}  // namespace program
