// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <istream>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <topobag/evaluation/number_text.hpp>
#include <topobag/evaluation/text_lines.hpp>
#include <topobag/matching/size_prior.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Writes what was learnt of each class's sizes (`learn_sizes`), a class a line, so that it reads
/// back as the same numbers.
inline void write_size_prior(std::ostream& out, const SizePrior& prior) {
  const auto precision = out.precision(std::numeric_limits<double>::max_digits10);
  out << "class_id,within_width,within_height,between_width,between_height\n";
  for (const auto& [label, spread] : prior.classes) {
    out << value(label) << ',' << spread.within[0] << ',' << spread.within[1] << ','
        << spread.between[0] << ',' << spread.between[1] << '\n';
  }
  out.precision(precision);
}

/// Reads it into the classes of `prior`, in place of those there.
/// @param name  of the file, for complaints
/// Throws Error with file and line for anything else, a class that comes twice, and standard
/// deviations that are negative or not finite.
inline SizePrior read_size_prior(std::istream& in, const std::string& name, SizePrior prior = {}) {
  prior.classes.clear();
  TextLines lines(in, name);
  std::vector<std::string_view> fields;
  bool is_first = true;
  for (std::string_view line; lines.next(line);) {
    TextLines::split(line, fields);
    const bool is_header = is_first && fields[0] == "class_id";
    is_first = false;
    if (is_header) continue;
    if (fields.size() != 5) {
      throw lines.error("a line has five numbers: the class, and how its widths and heights differ "
                        "within places and between them.");
    }
    const auto label = parse_number<std::int32_t>(fields[0]);
    if (!label) throw lines.error("'" + std::string(fields[0]) + "' is no number of a class.");
    const auto deviation = [&](std::size_t field) {
      const double read = lines.number(fields[field]);
      if (!(read >= 0.0) || std::isinf(read)) {
        throw lines.error("a standard deviation is finite and not negative.");
      }
      return read;
    };
    const SizeSpread spread{{deviation(1), deviation(2)}, {deviation(3), deviation(4)}};
    if (!prior.classes.emplace(ClassId{*label}, spread).second) {
      throw lines.error("class " + std::to_string(*label) + " comes twice.");
    }
  }
  return prior;
}

}  // namespace v0
}  // namespace topobag
