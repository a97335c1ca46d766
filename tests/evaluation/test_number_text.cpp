// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <string>

#include <topobag/evaluation/number_text.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a number is all of its text, but for blanks and a plus", "[evaluation]") {
  CHECK(parse_number(" +1.5\t") == 1.5);
  CHECK(parse_number("-2e3") == -2000.0);
  CHECK(parse_number("+7e-1\r") == 0.7);
  CHECK(std::isnan(*parse_number("nan")));
  for (const std::string bad :
       {"", " ", "+", "+-1", "--1", "1,5", "1.5m", "0x10", "1 2", "1e999"}) {
    CAPTURE(bad);
    CHECK_FALSE(parse_number(bad));
  }
}

TEST_CASE("a whole number may be written as a floating-point number", "[evaluation]") {
  CHECK(parse_whole("62") == 62);
  CHECK(parse_whole("62.0") == 62);
  CHECK(parse_whole(" -3e2 ") == -300);
  CHECK(parse_whole("9007199254740993") == std::int64_t{9007199254740993});
  for (const std::string bad : {"62.5", "1e300", "nan", "inf", "", "x", "62.0.0"}) {
    CAPTURE(bad);
    CHECK_FALSE(parse_whole(bad));
  }
}
