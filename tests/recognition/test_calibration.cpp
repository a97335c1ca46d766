// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include <topobag/recognition/calibration.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the null model serves until there are enough certain negatives", "[recognition]") {
  Calibration calibration;
  for (int i = 0; i < 500; ++i) calibration.add_null(5.0 + 0.001 * i);
  for (int i = 0; i < 199; ++i) calibration.add_negative(1.0 + 0.001 * i);
  CHECK(calibration.source() == CalibrationSource::null_model);
  CHECK(calibration.queries() == 500);
  CHECK(calibration.threshold(0.01).score > 5.0);
  calibration.add_negative(1.5);
  CHECK(calibration.source() == CalibrationSource::certain_negatives);
  CHECK(calibration.queries() == 200);
  CHECK(calibration.negatives() == 200);
  CHECK(calibration.threshold(0.01).score < 2.0);
}

TEST_CASE("the probability of a true match rises with the score, as far as queries can say",
          "[recognition]") {
  CalibrationOptions options;
  options.prior = 0.2;
  Calibration calibration(options);
  for (int i = 0; i < 400; ++i) calibration.add_null(-2.0 + 0.01 * i);
  CHECK(calibration.probability(-10.0) == Approx(0.2));
  double last = 0.0;
  for (double s = -4.0; s < 12.0; s += 0.1) {
    const double p = calibration.probability(s);
    CHECK(p >= last);
    CHECK(p < 1.0);
    CHECK(calibration.is_extrapolated(s) == (s > 1.99));
    last = p;
  }
  CHECK(last == Approx(0.2 / (0.2 + 0.8 / 401.0)));
  const double rate = calibration.false_accept_rate(1.0).rate;
  CHECK(calibration.probability(1.0) == Approx(0.2 / (0.2 + 0.8 * rate)));
}

TEST_CASE("so many negatives never say more than one in so many", "[recognition]") {
  for (const int negatives : {1, 20, 200, 2000}) {
    CalibrationOptions options;
    options.min_negatives = 1;
    Calibration calibration(options);
    for (int i = 0; i < negatives; ++i) {
      calibration.add_negative(i % 2 == 0 ? std::make_optional(0.01 * i) : std::nullopt);
    }
    for (const double score : {30.0, 100.0, 1000.0}) {
      CHECK(1.0 - calibration.probability(score) >= 0.99 / (negatives + 2.0));
      CHECK(calibration.probability(score) < 1.0);
      CHECK(calibration.is_extrapolated(score));
    }
  }
}

TEST_CASE("a calibration does not carry over from a map whose places look alike", "[recognition]") {
  Calibration calibration;
  CHECK(calibration.carries_over());  // nothing speaks against it
  for (int i = 0; i < 98; ++i) calibration.add_negative(1.0);
  calibration.add_negative(std::nullopt, true);  // no score, so beyond nothing
  CHECK(calibration.repeats() == 0);
  for (int i = 0; i < 2; ++i) calibration.add_negative(9.0, true);
  CHECK(calibration.carries_over());  // 2 of 101
  CHECK(calibration.carries_over().repeats == Approx(2.0 / 101.0));
  calibration.add_negative(9.0, true);
  CHECK_FALSE(calibration.carries_over());
  CHECK(calibration.carries_over().reason.find("3 of 102 queries match another place") == 0);
  for (int i = 0; i < 300; ++i) calibration.add_null(9.0);  // the null model has no say
  CHECK(calibration.carries_over().repeats == Approx(3.0 / 102.0));
  CalibrationOptions lenient;
  lenient.max_repeats = 0.05;
  CHECK(Calibration(lenient, calibration.negative_scores(), {}, 3).carries_over());
}

TEST_CASE("a calibration is made again of its parts", "[recognition]") {
  Calibration was;
  for (int i = 0; i < 250; ++i) {
    was.add_negative(0.01 * i, i > 240);
    was.add_null(0.02 * i);
  }
  const Calibration is(was.options(), was.negative_scores(), was.null_scores(), was.repeats());
  CHECK(is.source() == was.source());
  CHECK(is.repeats() == 9);
  CHECK(is.threshold(0.01).score == was.threshold(0.01).score);
  CHECK_THROWS_AS(Calibration({}, was.negative_scores(), was.null_scores(), 251), InvalidValue);
}

TEST_CASE("a calibration that has seen nothing extrapolates the chance model", "[recognition]") {
  const Calibration calibration;
  CHECK(calibration.source() == CalibrationSource::null_model);
  CHECK(calibration.threshold(1e-3).score == Approx(3.0));
  CHECK(calibration.threshold(1e-3).extrapolated);
  CHECK(calibration.probability(100.0) == Approx(0.5));  // the prior
  CHECK(calibration.is_extrapolated(100.0));
}

TEST_CASE("the prior of a true place and the share of repeats are shares", "[recognition]") {
  for (const double bad : {0.0, 1.0, std::nan("")}) {
    CalibrationOptions options;
    options.prior = bad;
    CHECK_THROWS_AS(Calibration(options), InvalidValue);
  }
  for (const double bad : {-0.1, 1.1, std::nan("")}) {
    CalibrationOptions options;
    options.max_repeats = bad;
    CHECK_THROWS_AS(Calibration(options), InvalidValue);
  }
}
