// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/recognition/calibration.hpp>
#include <topobag/recognition/calibration_conditions.hpp>
#include <topobag/types/detail/value_lines.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

// The latest; 1 has no appearance, and up to 2 none of shares other than the defaults, nor how many
// places were asked, nor conditions.
inline constexpr std::size_t calibration_version = 3;

inline void append_scores(std::string& text, const std::string& key, const FalseScores& scores) {
  text += key + "_look_ups " + exact_text(scores.size()) + '\n';
  text += key + "_scores " + exact_text(scores.scores().size()) + '\n';
  for (const double score : scores.scores()) text += exact_text(score) + '\n';
}

inline FalseScores read_scores(ValueLines& lines, const std::string& key) {
  const auto queries = lines.number<std::size_t>(lines.behind(key + "_look_ups"));
  const auto count = lines.number<std::size_t>(lines.behind(key + "_scores"));
  std::vector<double> scores;  // not reserved: the count is a claim
  while (scores.size() < count) scores.push_back(lines.number<double>(lines.next()));
  try {
    return FalseScores(queries, std::move(scores));
  } catch (const InvalidValue& error) {
    lines.fail(std::string(error.what()) + '.');
  }
}

/// The least version that holds the calibration.
inline std::size_t least_calibration_version(const Calibration& calibration) {
  if (calibration.asked_places().queries > 0) return 3;
  if (!calibration.conditions().stated().empty()) return 3;
  if (!calibration.appearance()) return 1;
  const AppearanceModel usual;
  const bool usual_shares = calibration.appearance()->furnished_alike == usual.furnished_alike &&
                            calibration.appearance()->light_changed == usual.light_changed;
  return usual_shares ? 2 : 3;
}

inline void append_conditions(std::string& text, const CalibrationConditions& conditions) {
  if (conditions.stated().empty()) return;
  text += "conditions " + exact_text(conditions.stated().size()) + '\n';
  for (const auto& [name, value] : conditions.stated()) text += name + ' ' + value + '\n';
}

inline CalibrationConditions read_conditions(ValueLines& lines) {
  CalibrationConditions conditions;
  if (!lines.next_begins("conditions ")) return conditions;
  const auto count = lines.number<std::size_t>(lines.behind("conditions"));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string line(lines.next());
    const std::size_t blank = std::min(line.find(' '), line.size());
    const std::size_t stated = conditions.stated().size();
    try {
      conditions.set(line.substr(0, blank), line.substr(std::min(blank + 1, line.size())));
    } catch (const InvalidValue& error) {
      lines.fail(std::string(error.what()) + '.');
    }
    if (conditions.stated().size() == stated) lines.fail("a condition is stated twice.");
  }
  return conditions;
}

/// @param version  of the text
inline void append_appearance(std::string& text, const AppearanceModel& model,
                              std::size_t version) {
  text += "appearance_kind " + exact_text(model.kind.number()) + '\n';
  text += "appearance_length " + exact_text(model.kind.length()) + '\n';
  text += "appearance_points " + exact_text(model.table.size()) + '\n';
  for (const AppearanceOdds& point : model.table) {
    text += exact_text(point.similarity) + '\n' + exact_text(point.log10_odds) + '\n';
  }
  if (version < 3) return;
  text += "furnished_alike " + exact_text(model.furnished_alike) + '\n';
  text += "light_changed " + exact_text(model.light_changed) + '\n';
}

/// @param version  of the text
inline AppearanceModel read_appearance(ValueLines& lines, std::size_t version) {
  const auto kind = lines.number<std::uint32_t>(lines.behind("appearance_kind"));
  const auto length = lines.number<std::size_t>(lines.behind("appearance_length"));
  const auto count = lines.number<std::size_t>(lines.behind("appearance_points"));
  AppearanceModel model;
  model.table.clear();
  while (model.table.size() < count) {  // not reserved: the count is a claim
    const auto similarity = lines.number<double>(lines.next());
    model.table.push_back({similarity, lines.number<double>(lines.next())});
  }
  if (version >= 3) {
    model.furnished_alike = lines.number<double>(lines.behind("furnished_alike"));
    model.light_changed = lines.number<double>(lines.behind("light_changed"));
  }
  try {
    model.kind = AppearanceKind(kind, length);
    model.validate();
  } catch (const InvalidValue& error) {
    lines.fail(std::string(error.what()) + '.');
  }
  return model;
}

}  // namespace detail

/// A calibration as text, a value on each line: its version, the least that holds it, what it goes
/// by, its options, the queries and their scores, and, where they are known, the places that were
/// asked, under which conditions, and what looks say. `parse_calibration` turns it back into the
/// same one, to the last bit; no locale has a say. O(n).
inline std::string to_string(const Calibration& calibration) {
  const CalibrationOptions& options = calibration.options();
  const std::size_t version = detail::least_calibration_version(calibration);
  std::string text = "topobag calibration " + detail::exact_text(version) + '\n';
  text += "source " + std::string(to_string(calibration.source())) + '\n';
  text += "min_negatives " + detail::exact_text(options.min_negatives) + '\n';
  text += "prior " + detail::exact_text(options.prior) + '\n';
  text += "max_repeats " + detail::exact_text(options.max_repeats) + '\n';
  text += "repeats " + detail::exact_text(calibration.repeats()) + '\n';
  detail::append_scores(text, "negative", calibration.negative_scores());
  detail::append_scores(text, "null", calibration.null_scores());
  if (version >= 3) {
    text += "places_look_ups " + detail::exact_text(calibration.asked_places().queries) + '\n';
    text += "places_asked " + detail::exact_text(calibration.asked_places().places) + '\n';
    detail::append_conditions(text, calibration.conditions());
  }
  if (calibration.appearance()) detail::append_appearance(text, *calibration.appearance(), version);
  return text + "end\n";
}

/// The calibration of such a text. Throws FormatError, with the line and in `index()` its number,
/// for one that is none, cut off, damaged so that it contradicts itself, or of a later version.
/// O(n log n).
inline Calibration parse_calibration(std::string_view text) {
  detail::ValueLines lines("calibration", text);
  const std::size_t version = lines.version(detail::calibration_version);
  const std::string source(lines.behind("source"));
  CalibrationOptions options;
  options.min_negatives = lines.number<std::size_t>(lines.behind("min_negatives"));
  options.prior = lines.number<double>(lines.behind("prior"));
  options.max_repeats = lines.number<double>(lines.behind("max_repeats"));
  const auto repeats = lines.number<std::size_t>(lines.behind("repeats"));
  FalseScores negatives = detail::read_scores(lines, "negative");
  FalseScores null = detail::read_scores(lines, "null");
  AskedPlaces asked;
  CalibrationConditions conditions;
  if (version == 3) {
    asked.queries = lines.number<std::size_t>(lines.behind("places_look_ups"));
    asked.places = lines.number<std::size_t>(lines.behind("places_asked"));
    conditions = detail::read_conditions(lines);
  }
  std::optional<AppearanceModel> appearance;
  if (version == 2 || (version >= 3 && lines.next_begins("appearance_kind "))) {
    appearance = detail::read_appearance(lines, version);
  }
  if (lines.next() != "end") lines.fail("'end' is missing.");
  try {
    Calibration calibration(options, std::move(negatives), std::move(null), repeats);
    if (source != to_string(calibration.source())) {
      lines.fail("the queries do not make its source '" + source + "'.");
    }
    lines.require_end();
    calibration.set_asked_places(asked);
    calibration.set_conditions(std::move(conditions));
    if (appearance) calibration.set_appearance(*appearance);
    return calibration;
  } catch (const InvalidValue& error) {
    lines.fail(std::string(error.what()) + '.');
  }
}

}  // namespace v0
}  // namespace topobag
