// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <topobag/recognition/calibration_text.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

Calibration stated_calibration(const CalibrationConditions& conditions) {
  Calibration calibration;
  calibration.add_null(0.25);
  calibration.add_null(std::nullopt);
  calibration.set_conditions(conditions);
  return calibration;
}

CalibrationConditions small_conditions() {
  CalibrationConditions conditions;
  conditions.set("window", "3");
  conditions.set("detector", "yolox nano, 416 px");
  return conditions;
}

}  // namespace

TEST_CASE("conditions that both state otherwise are named", "[recognition]") {
  CalibrationConditions here = small_conditions();
  CHECK(here.differing(small_conditions()).empty());
  here.set("window", "0");
  here.set("robot", "7");
  CHECK(here.differing(small_conditions()) == std::vector<std::string>{"window"});
  CHECK(small_conditions().differing(here) == std::vector<std::string>{"window"});
  here.set("detector", "picodet");
  CHECK(here.differing(small_conditions()) == std::vector<std::string>{"detector", "window"});
  CHECK(here.differing(CalibrationConditions()).empty());
}

TEST_CASE("a condition is a word and a line", "[recognition]") {
  CalibrationConditions conditions;
  for (const char* name : {"", "a b", "a\n", "\x7F"}) {
    CHECK_THROWS_AS(conditions.set(name, "1"), InvalidValue);
  }
  for (const char* value : {"", "1\n2", "1\r", "\t"}) {
    CHECK_THROWS_AS(conditions.set("window", value), InvalidValue);
  }
  CHECK(conditions.stated().empty());
  conditions.set("größe", "fünf");
  CHECK(conditions.stated().at("größe") == "fünf");
}

TEST_CASE("conditions are kept with a calibration and change none of its answers",
          "[recognition]") {
  const Calibration plain = stated_calibration({});
  CHECK(to_string(plain).find("topobag calibration 1\n") == 0);
  CHECK(parse_calibration(to_string(plain)).conditions().stated().empty());

  const Calibration stated = stated_calibration(small_conditions());
  const std::string text = to_string(stated);
  CHECK(text.find("topobag calibration 3\n") == 0);
  CHECK(text.find("conditions 2\ndetector yolox nano, 416 px\nwindow 3\n") != text.npos);
  const Calibration back = parse_calibration(text);
  CHECK(back.conditions().stated() == small_conditions().stated());
  CHECK(to_string(back) == text);
  CHECK(back.threshold(0.01).score == plain.threshold(0.01).score);
  for (std::size_t size = 0; size < text.size(); ++size) {
    CHECK_THROWS_AS(parse_calibration(std::string_view(text).substr(0, size)), FormatError);
  }
}

TEST_CASE("conditions that are none are refused with their line", "[recognition]") {
  const std::string text = to_string(stated_calibration(small_conditions()));
  const auto refused_with = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return error_text([&] { parse_calibration(other); });
  };
  CHECK(refused_with("conditions 2", "conditions 1").find("'end' is missing") != std::string::npos);
  CHECK(refused_with("conditions 2", "conditions two").find("not a number") != std::string::npos);
  CHECK(refused_with("window 3", "window").find("'window' must be a line of text") !=
        std::string::npos);
  CHECK(refused_with("window 3", "detector 3") ==
        "calibration, line 16: a condition is stated twice.");
  CHECK(refused_with("calibration 3", "calibration 4").find("later than this library's, 3") !=
        std::string::npos);
}
