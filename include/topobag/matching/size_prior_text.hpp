// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <topobag/error.hpp>
#include <topobag/matching/size_prior.hpp>
#include <topobag/types/detail/value_lines.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

inline constexpr std::size_t size_prior_version = 1;  // the latest

inline std::string spread_text(const SizeSpread& spread) {
  return exact_text(spread.within[0]) + ' ' + exact_text(spread.within[1]) + ' ' +
         exact_text(spread.between[0]) + ' ' + exact_text(spread.between[1]);
}

/// All of `text` as a spread, the number that each stands for not below zero.
inline SizeSpread read_spread(const ValueLines& lines, std::string_view text) {
  std::array<double, 4> numbers{};
  for (double& number : numbers) {
    number = lines.take<double>(text);
    if (!(std::isfinite(number) && number >= 0.0))
      lines.fail("a deviation is no number from 0 on.");
  }
  if (!text.empty()) lines.fail("a spread has four numbers.");
  return {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

}  // namespace detail

/// What sizes say, as text, a value on each line: `parse_size_prior` turns it back into the same,
/// to the last bit; no locale has a say. O(classes).
inline std::string to_string(const SizePrior& prior) {
  std::string text = "topobag size prior 1\n";
  text += "deviation " + detail::exact_text(prior.deviation) + '\n';
  text += "outliers " + detail::exact_text(prior.outliers) + '\n';
  text += "spread " + detail::spread_text(prior.spread) + '\n';
  text += "classes " + detail::exact_text(prior.classes.size()) + '\n';
  for (const auto& [label, spread] : prior.classes) {
    text += detail::exact_text(value(label)) + ' ' + detail::spread_text(spread) + '\n';
  }
  return text + "end\n";
}

/// The prior of such a text, for `ChanceModel::sizes`. Its classes are numbers: it goes with the
/// catalog it was learnt with. Throws FormatError, with the line and in `index()` its number, for a
/// text that is none, cut off, of a later version, with a class twice or with a number out of its
/// range. O(n log n).
inline SizePrior parse_size_prior(std::string_view text) {
  detail::ValueLines lines("size prior", text);
  lines.version(detail::size_prior_version);
  SizePrior prior;
  prior.deviation = lines.number<double>(lines.behind("deviation"));
  if (!(std::isfinite(prior.deviation) && prior.deviation > 0.0)) {
    lines.fail("the deviation is no number above 0.");
  }
  prior.outliers = lines.number<double>(lines.behind("outliers"));
  if (!(prior.outliers >= 0.0 && prior.outliers <= 1.0)) {
    lines.fail("the share of outliers is not in [0, 1].");
  }
  prior.spread = detail::read_spread(lines, lines.behind("spread"));
  const auto count = lines.number<std::size_t>(lines.behind("classes"));
  for (std::size_t i = 0; i < count; ++i) {
    std::string_view line = lines.next();
    const auto label = static_cast<ClassId>(lines.take<std::int32_t>(line));
    if (!prior.classes.emplace(label, detail::read_spread(lines, line)).second) {
      lines.fail("class " + std::to_string(value(label)) + " is there already.");
    }
  }
  if (lines.next() != "end") lines.fail("'end' is missing.");
  lines.require_end();
  return prior;
}

}  // namespace v0
}  // namespace topobag
