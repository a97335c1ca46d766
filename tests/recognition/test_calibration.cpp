// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/recognition/calibration.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the null model serves until there are enough certain negatives", "[recognition]") {
  Calibration calibration;
  for (int i = 0; i < 500; ++i) calibration.add_null(5.0 + 0.001 * i);
  for (int i = 0; i < 199; ++i) calibration.add_negative(1.0 + 0.001 * i);
  CHECK(calibration.source() == CalibrationSource::null_model);
  CHECK(calibration.look_ups() == 500);
  CHECK(calibration.threshold(0.01).score > 5.0);
  calibration.add_negative(1.5);
  CHECK(calibration.source() == CalibrationSource::certain_negatives);
  CHECK(calibration.look_ups() == 200);
  CHECK(calibration.negatives() == 200);
  CHECK(calibration.threshold(0.01).score < 2.0);
}

TEST_CASE("the probability of a true match rises with the score, from the prior to one",
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
    CHECK(p <= 1.0);
    last = p;
  }
  CHECK(last > 0.999);
  const double rate = calibration.false_accept_rate(1.0).rate;
  CHECK(calibration.probability(1.0) == Approx(0.2 / (0.2 + 0.8 * rate)));
}

TEST_CASE("a calibration that has seen nothing extrapolates the chance model", "[recognition]") {
  const Calibration calibration;
  CHECK(calibration.source() == CalibrationSource::null_model);
  CHECK(calibration.threshold(1e-3).score == Approx(3.0));
  CHECK(calibration.threshold(1e-3).extrapolated);
}

TEST_CASE("the prior of a true place is a probability", "[recognition]") {
  for (const double bad : {0.0, 1.0, std::nan("")}) {
    CalibrationOptions options;
    options.prior = bad;
    CHECK_THROWS_AS(Calibration(options), InvalidValue);
  }
}
