// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <topobag/matching/layout_prior.hpp>
#include <topobag/types/detail/value_lines.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

inline constexpr std::size_t layout_prior_version = 1;  // the latest

inline std::string counts_text(const DistanceCounts& counts) {
  std::string text;
  for (const double count : counts) text += ' ' + exact_text(count);
  return text + '\n';
}

/// All of `text` as counts, none below zero.
inline DistanceCounts read_counts(const ValueLines& lines, std::string_view text) {
  DistanceCounts counts{};
  for (double& count : counts) {
    count = lines.take<double>(text);
    if (!(std::isfinite(count) && count >= 0.0)) lines.fail("a count is no number from 0 on.");
  }
  if (!text.empty()) lines.fail("there are more counts than distances.");
  return counts;
}

}  // namespace detail

/// What layouts say, as text: `parse_layout_prior` turns it back into the same; no locale has a
/// say. O(pairs of classes).
inline std::string to_string(const LayoutPrior& prior) {
  std::string text = "topobag layout prior 1\n";
  text += "even " + detail::exact_text(prior.even) + '\n';
  text += "pooled " + detail::exact_text(prior.pooled) + '\n';
  std::size_t pairs = 0;
  std::string rows;
  prior.for_each(
      [&](ClassId a, ClassId b, const DistanceCounts& level, const DistanceCounts& spatial) {
        ++pairs;
        rows += "classes " + detail::exact_text(value(a)) + ' ' + detail::exact_text(value(b)) +
                "\nlevel" + detail::counts_text(level) + "spatial" + detail::counts_text(spatial);
      });
  return text + "pairs " + detail::exact_text(pairs) + '\n' + rows + "end\n";
}

/// The prior of such a text, for `ChanceModel::layouts`. Its classes are numbers: it goes with the
/// catalog it was learnt with. Throws FormatError, with the line and in `index()` its number, for a
/// text that is none, cut off, of a later version, or with a number out of its range.
/// O(n log n).
inline LayoutPrior parse_layout_prior(std::string_view text) {
  detail::ValueLines lines("layout prior", text);
  lines.version(detail::layout_prior_version);
  LayoutPrior prior;
  prior.even = lines.number<double>(lines.behind("even"));
  if (!(prior.even > 0.0 && prior.even <= 1.0)) {
    lines.fail("the share of what stands anywhere is not in (0, 1].");
  }
  prior.pooled = lines.number<double>(lines.behind("pooled"));
  if (!(std::isfinite(prior.pooled) && prior.pooled > 0.0)) {
    lines.fail("the number of pooled places is no number above 0.");
  }
  const auto pairs = lines.number<std::size_t>(lines.behind("pairs"));
  for (std::size_t i = 0; i < pairs; ++i) {
    std::string_view classes = lines.behind("classes");
    const auto a = static_cast<ClassId>(lines.take<std::int32_t>(classes));
    const auto b = static_cast<ClassId>(lines.take<std::int32_t>(classes));
    if (!classes.empty()) lines.fail("a pair has two classes.");
    const DistanceCounts level = detail::read_counts(lines, lines.behind("level"));
    prior.add(a, b, level, detail::read_counts(lines, lines.behind("spatial")));
  }
  if (lines.next() != "end") lines.fail("'end' is missing.");
  lines.require_end();
  return prior;
}

}  // namespace v0
}  // namespace topobag
