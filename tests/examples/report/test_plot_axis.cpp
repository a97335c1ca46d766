// SPDX-License-Identifier: MIT
#include "report/plot_axis.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"

using program::round_ticks;
using program::Tick;

TEST_CASE("ticks are round, evenly spaced, inside and few, and say their value",
          "[examples][report]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> exponent(-4.0, 5.0);
  std::uniform_real_distribution<double> offset(-5.0, 5.0);
  for (int round = 0; round < 500; ++round) {
    const double size = std::pow(10.0, exponent(random));
    const double low = offset(random) * size;
    const double high = low + size;
    CAPTURE(low, high);
    const std::vector<Tick> ticks = round_ticks(low, high);
    REQUIRE(ticks.size() >= 2);
    CHECK(ticks.size() <= 7);
    const double step = ticks[1].value - ticks[0].value;
    const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    CHECK((digit == Approx(1.0) || digit == Approx(2.0) || digit == Approx(5.0)));
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      CHECK(ticks[i].value >= low - 1e-5 * step);
      CHECK(ticks[i].value <= high + 1e-5 * step);
      CHECK(ticks[i].value ==
            Approx(ticks[0].value + static_cast<double>(i) * step).margin(1e-6 * step));
      CHECK(std::stod(ticks[i].text) == Approx(ticks[i].value).margin(1e-6 * step));
    }
  }
}

TEST_CASE("ticks by hand", "[examples][report]") {
  std::string texts;
  for (const Tick& tick : round_ticks(-0.1, 1.0, 7)) texts += tick.text + ' ';
  CHECK(texts == "0.0 0.2 0.4 0.6 0.8 1.0 ");
}

TEST_CASE("an axis is never empty", "[examples][report]") {
  for (const double value : {-3.0, 0.0, 1e6}) {
    const auto axis = program::round_axis("x", value, value);
    CHECK(axis.low < value);
    CHECK(axis.high > value);
    CHECK(axis.ticks.size() >= 2);
  }
  CHECK(program::axis_from_zero("n", 0.0).high > 0.0);
  CHECK(program::axis_from_zero("n", 45.0).high == Approx(50.0));
  CHECK(program::axis_from_zero("n", 50.0).high == Approx(50.0));
}
