// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/error.hpp>
#include <topobag/recognition/decision_options.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("ten times the places, or a tenth of the rate, ask for one decade more",
          "[recognition]") {
  DecisionOptions options;
  for (const std::size_t places : {1U, 7U, 300U, 100000U}) {
    CHECK(options.threshold(10 * places) == Approx(options.threshold(places) + 1.0));
    DecisionOptions rarer = options;
    rarer.false_accept_rate = options.false_accept_rate / 10.0;
    CHECK(rarer.threshold(places) == Approx(options.threshold(places) + 1.0));
  }
  CHECK(options.threshold(0) == options.threshold(1));
}

TEST_CASE("by default one query in a thousand may be accepted falsely", "[recognition]") {
  const DecisionOptions options;
  CHECK(options.false_accept_rate == 1e-3);
  // The expected number of false matches, N · 10^−score, less what the model is too careful by.
  const double score = options.threshold(50);
  CHECK(50.0 * std::pow(10.0, -score - options.surplus) == Approx(options.false_accept_rate));
}

TEST_CASE("more is asked of graphs of which nothing can be missing", "[recognition]") {
  const DecisionOptions options;
  CHECK(options.threshold(7, false) - options.threshold(7, true) ==
        Approx(options.surplus - options.surplus_without_views));
  CHECK(options.surplus > options.surplus_without_views);
}

TEST_CASE("a score that is asked for goes before the rate", "[recognition]") {
  DecisionOptions options;
  options.min_score = 4.5;
  CHECK(options.threshold(1) == 4.5);
  CHECK(options.threshold(1000000) == 4.5);
}

TEST_CASE("a rate outside (0, 1] is refused", "[recognition]") {
  for (const double rate : {0.0, -0.1, 1.5, std::nan("")}) {
    DecisionOptions options;
    options.false_accept_rate = rate;
    CHECK_THROWS_AS(options.threshold(1), InvalidValue);
  }
}

TEST_CASE("a calibration is asked by the places of the whole map", "[recognition]") {
  DecisionOptions options;
  options.calibration.emplace();
  for (int i = 0; i < 400; ++i) options.calibration->add_null(0.01 * i, 30);
  const double learnt = options.calibration->threshold(1e-3).score;
  for (const bool with_views : {false, true}) {
    CHECK(options.threshold(7, with_views) == learnt);
    CHECK(options.threshold(7, with_views, 30) == learnt);
    CHECK(options.threshold(7, with_views, 300) >= learnt + 1.0);
    CHECK(options.threshold(7, with_views, 300) == options.calibration->threshold(1e-3, 300).score);
  }
  options.min_score = 4.5;
  CHECK(options.threshold(7, true, 300) == 4.5);
}
