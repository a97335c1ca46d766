// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <limits>
#include <locale>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <topobag/recognition/calibration_text.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

Calibration drawn_calibration(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 3.0);
  CalibrationOptions options;
  options.min_negatives = seed % 40;
  options.prior = 0.1 + 0.8 / (1.0 + seed);
  options.max_repeats = 1.0 / (1.0 + seed);
  Calibration calibration(options);
  for (std::uint32_t i = 0; i < 30 * (seed % 3); ++i) {
    const bool scored = random() % 3 != 0;
    calibration.add_negative(scored ? std::make_optional(normal(random)) : std::nullopt,
                             random() % 4 == 0);
    calibration.add_null(scored ? std::nullopt : std::make_optional(normal(random)));
  }
  return calibration;
}

const std::string small =
    "topobag calibration 1\n"
    "source null model\n"
    "min_negatives 200\n"
    "prior 0.5\n"
    "max_repeats 0.02\n"
    "repeats 1\n"
    "negative_look_ups 3\n"
    "negative_scores 1\n"
    "2.5\n"
    "null_look_ups 2\n"
    "null_scores 2\n"
    "0.1\n"
    "-1e-300\n"
    "end\n";

/// `small` with one thing replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = small;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// How a text is refused.
std::string refused(const std::string& text) {
  CHECK_THROWS_AS(parse_calibration(text), FormatError);
  return error_text([&] { parse_calibration(text); });
}

/// A locale that writes 1.234,5.
struct CommaNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST_CASE("a calibration comes back from its text to the last bit", "[recognition]") {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const Calibration was = drawn_calibration(seed);
    const std::string text = to_string(was);
    const Calibration is = parse_calibration(text);
    CAPTURE(seed);
    CHECK(is.negative_scores().scores() == was.negative_scores().scores());
    CHECK(is.null_scores().scores() == was.null_scores().scores());
    CHECK(is.negatives() == was.negatives());
    CHECK(is.queries() == was.queries());
    CHECK(is.source() == was.source());
    CHECK(is.repeats() == was.repeats());
    CHECK(is.carries_over().reason == was.carries_over().reason);
    CHECK(is.options().prior == was.options().prior);
    for (double score = -5.0; score < 15.0; score += 0.7) {
      CHECK(is.probability(score) == was.probability(score));
    }
    for (const double rate : {0.5, 0.03, 1e-3, 1e-7}) {
      CHECK(is.threshold(rate).score == was.threshold(rate).score);
    }
    CHECK(to_string(is) == text);
  }
}

TEST_CASE("scores of any size come back exactly", "[recognition]") {
  Calibration was;
  for (const double score : {0.1, 1.0 / 3.0, -0.0, 5e-324, -1.7976931348623157e308,
                             std::numeric_limits<double>::max(), 2.2250738585072014e-308}) {
    was.add_null(score);
  }
  CHECK(parse_calibration(to_string(was)).null_scores().scores() == was.null_scores().scores());
}

TEST_CASE("no locale changes a calibration's text", "[recognition]") {
  const Calibration calibration = drawn_calibration(8);
  const std::string text = to_string(calibration);
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaNumbers));
  const std::string elsewhere = to_string(calibration);
  const std::string back = to_string(parse_calibration(text));
  std::locale::global(before);
  CHECK(elsewhere == text);
  CHECK(back == text);
}

TEST_CASE("a calibration's text is read as it is written by hand", "[recognition]") {
  const Calibration calibration = parse_calibration(small);
  CHECK(calibration.negatives() == 3);
  CHECK(calibration.repeats() == 1);
  CHECK(calibration.queries() == 2);
  CHECK(calibration.null_scores().scores() == std::vector<double>{0.1, -1e-300});
  CHECK(to_string(calibration) == small);
  std::string windows = small;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) {
    windows.insert(at, "\r");
  }
  CHECK(to_string(parse_calibration(windows)) == small);
}

TEST_CASE("a calibration that is cut off anywhere is refused", "[recognition]") {
  for (std::size_t size = 0; size < small.size(); ++size) {
    CAPTURE(size);
    const std::string text = refused(small.substr(0, size));
    CHECK(text.find("calibration, line ") == 0);
    if (size > 20) CHECK(text.find("cut off") != std::string::npos);
  }
}

TEST_CASE("what is no calibration is refused with the line", "[recognition]") {
  const auto says = [&](const std::string& text, std::size_t line, const std::string& sentence) {
    const std::string why = refused(text);
    CAPTURE(why);
    CHECK(why.find("line " + std::to_string(line) + ": ") != std::string::npos);
    CHECK(why.find(sentence) != std::string::npos);
    try {
      parse_calibration(text);
    } catch (const FormatError& error) {
      CHECK(error.index() == line);
    }
  };
  says("", 1, "no calibration");
  says("idx,timestamp\n", 1, "no calibration");
  says(changed("calibration 1", "calibration 4"), 1, "later than this library's");
  says(changed("calibration 1", "calibration 0"), 1, "no such version");
  says(changed("calibration 1", "calibration 2"), 14, "'appearance_kind' and its value");
  says(changed("calibration 1", "calibration 3"), 14, "'places_look_ups' and its value");
  says(changed("calibration 1", "calibration one"), 1, "not a number");
  says(changed("null model", "certain negatives"), 14, "do not make its source");
  says(changed("prior 0.5", "0.5"), 4, "'prior' and its value are missing");
  says(changed("prior 0.5", "prior 0,5"), 4, "'0,5' is not a number");
  says(changed("prior 0.5", "prior 1"), 14, "in (0, 1)");
  says(changed("repeats 1\n", "repeats 2\n"), 14, "more repeats");
  says(changed("negative_look_ups 3", "negative_look_ups -3"), 7, "not a number");
  says(changed("negative_look_ups 3", "negative_look_ups 0"), 9, "more false scores than queries");
  says(changed("2.5", "nan"), 9, "finite");
  says(changed("2.5", "2.5 "), 9, "not a number");
  says(changed("null_scores 2", "null_scores 3"), 14, "'end' is not a number");
  says(changed("null_scores 2", "null_scores 1"), 13, "'end' is missing");
  says(small + "more", 15, "behind the end");
}

TEST_CASE("a count is only a claim until its scores are read", "[recognition]") {
  const std::string huge = changed("null_scores 2", "null_scores 18446744073709551615");
  CHECK(refused(huge).find("'end' is not a number") != std::string::npos);
  std::string many = changed("negative_look_ups 3", "negative_look_ups 18446744073709551615");
  many.replace(many.find("null model"), 10, "certain negatives");
  CHECK(parse_calibration(many).negatives() == std::numeric_limits<std::size_t>::max());
}

TEST_CASE("what looks say is saved with the calibration", "[recognition][appearance]") {
  Calibration calibration = drawn_calibration(5);
  CHECK_FALSE(calibration.appearance());
  CHECK(to_string(calibration).find("topobag calibration 1\n") == 0);
  AppearanceModel model;
  model.kind = AppearanceKind("clip", 32);
  model.table = {{0.1, -0.9}, {1.0 / 3.0, 0.1}, {0.8, 0.1}};
  calibration.set_appearance(model);
  const std::string text = to_string(calibration);
  CHECK(text.find("topobag calibration 2\n") == 0);
  const Calibration back = parse_calibration(text);
  REQUIRE(back.appearance());
  CHECK(back.appearance()->kind == model.kind);
  REQUIRE(back.appearance()->table.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(back.appearance()->table[i].similarity == model.table[i].similarity);
    CHECK(back.appearance()->table[i].log10_odds == model.table[i].log10_odds);
  }
  CHECK(to_string(back) == text);
  for (std::size_t size = 0; size < text.size(); ++size) {
    CHECK_THROWS_AS(parse_calibration(std::string_view(text).substr(0, size)), FormatError);
  }
  const auto refuses = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return refused(other);
  };
  CHECK(refuses("appearance_length 32", "appearance_length 65").find("1 to 64") !=
        std::string::npos);
  CHECK(refuses("appearance_points 3", "appearance_points 2").find("'end' is missing") !=
        std::string::npos);
  CHECK(refuses("\n0.8\n", "\n0.2\n").find("do not rise with similarity at point 2") !=
        std::string::npos);
  CHECK(refuses("\n0.8\n", "\ninf\n").find("do not rise") != std::string::npos);
  model.table.push_back({0.8, 0.2});
  CHECK_THROWS_AS(calibration.set_appearance(model), InvalidValue);
  CHECK(calibration.appearance()->table.size() == 3);
}

TEST_CASE("shares of looks other than the usual are saved too", "[recognition][appearance]") {
  Calibration calibration = drawn_calibration(5);
  AppearanceModel model;
  model.furnished_alike = 1.0 / 3.0;
  calibration.set_appearance(model);
  const std::string text = to_string(calibration);
  CHECK(text.find("topobag calibration 3\n") == 0);
  const Calibration back = parse_calibration(text);
  REQUIRE(back.appearance());
  CHECK(back.appearance()->furnished_alike == model.furnished_alike);
  CHECK(back.appearance()->light_changed == model.light_changed);
  CHECK(to_string(back) == text);
  for (const std::string share : {"-0.1", "1.1", "nan"}) {
    std::string other = text;
    other.replace(other.find("light_changed 0.03"), 18, "light_changed " + share);
    CHECK(refused(other).find("must be in [0, 1]") != std::string::npos);
    model.light_changed = std::stod(share);
    CHECK_THROWS_AS(calibration.set_appearance(model), InvalidValue);
  }
}
