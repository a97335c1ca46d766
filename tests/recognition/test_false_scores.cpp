// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <topobag/recognition/false_scores.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the rate within what was seen, by count", "[recognition]") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  FalseScores scores;
  std::vector<double> drawn;
  for (int i = 0; i < 300; ++i) {
    if (i % 3 == 0) {
      scores.add(std::nullopt);
      continue;
    }
    drawn.push_back(normal(random));
    scores.add(drawn.back());
  }
  REQUIRE(scores.size() == 300);
  const double most = *std::max_element(drawn.begin(), drawn.end());
  for (double s = -4.0; s <= most; s += 0.05) {
    const auto above = std::count_if(drawn.begin(), drawn.end(), [&](double x) { return x >= s; });
    const FalseAcceptRate rate = scores.rate(s);
    CHECK(rate.rate == Approx((static_cast<double>(above) + 1.0) / 301.0));
    CHECK_FALSE(rate.extrapolated);
  }
  CHECK(scores.rate(most).rate == Approx(2.0 / 301.0));
}

TEST_CASE("the threshold is the least that keeps the rate", "[recognition]") {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  FalseScores scores;
  for (int i = 0; i < 400; ++i) scores.add(normal(random));
  for (double rate = 1.0 / 401.0; rate < 1.0; rate += 0.003) {
    const ScoreThreshold threshold = scores.threshold(rate);
    CAPTURE(rate);
    CHECK_FALSE(threshold.extrapolated);
    CHECK(scores.rate(threshold.score).rate <= rate);
    CHECK(scores.rate(threshold.score - 1e-9).rate > rate);
  }
}

TEST_CASE("a rate below one in those seen is extrapolated, and falls without end",
          "[recognition]") {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  FalseScores scores;
  for (int i = 0; i < 200; ++i) scores.add(normal(random));
  CHECK_FALSE(scores.threshold(1.0 / 200.0).extrapolated);
  CHECK(scores.threshold(1.0 / 202.0).extrapolated);
  double last = scores.threshold(1.0 / 200.0).score;
  for (const double rate : {4e-3, 1e-3, 1e-4, 1e-6, 1e-9}) {
    const ScoreThreshold threshold = scores.threshold(rate);
    CHECK(threshold.extrapolated);
    CHECK(threshold.score >= last);
    CHECK(std::isfinite(threshold.score));
    last = threshold.score;
    const FalseAcceptRate back = scores.rate(threshold.score);
    CHECK(back.extrapolated);
    CHECK(back.rate > 0.0);
    CHECK(back.rate <= rate * (1.0 + 1e-9));
  }
}

TEST_CASE("the rate never rises with the threshold", "[recognition]") {
  std::mt19937 random(4);
  std::exponential_distribution<double> exponential(1.0);
  for (int round = 0; round < 50; ++round) {
    FalseScores scores;
    for (int i = 0; i < 1 + 5 * round; ++i) {
      scores.add(random() % 2 == 0 ? std::make_optional(exponential(random)) : std::nullopt);
    }
    double last = 1.0;
    for (double s = -1.0; s < 20.0; s += 0.01) {
      const double rate = scores.rate(s).rate;
      CHECK(rate <= last);
      CHECK(rate > 0.0);
      last = rate;
    }
  }
}

TEST_CASE("an exponential tail is extrapolated to what it is", "[recognition]") {
  std::mt19937 random(5);
  std::exponential_distribution<double> exponential(1.0);  // half of what the chance model allows
  FalseScores scores;
  for (int i = 0; i < 4000; ++i) scores.add(exponential(random));
  CHECK(scores.threshold(1e-5).score == Approx(-std::log(1e-5)).epsilon(0.1));
}

TEST_CASE("the share of further false queries above the threshold is the rate", "[recognition]") {
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  double accepted = 0.0, all = 0.0;
  for (int round = 0; round < 400; ++round) {
    FalseScores scores;
    for (int i = 0; i < 250; ++i) scores.add(normal(random));
    const double threshold = scores.threshold(0.02).score;
    for (int i = 0; i < 50; ++i, ++all) accepted += normal(random) >= threshold ? 1.0 : 0.0;
  }
  CHECK(accepted / all < 0.022);
  CHECK(accepted / all > 0.013);
}

TEST_CASE("without scores the chance model alone answers", "[recognition]") {
  const FalseScores none;
  CHECK(none.threshold(0.01).score == Approx(2.0));
  CHECK(none.threshold(0.01).extrapolated);
  CHECK(none.rate(3.0).rate == Approx(1e-3));
  CHECK(none.rate(-5.0).rate == 1.0);
  FalseScores refused;  // nothing ever agreed
  for (int i = 0; i < 99; ++i) refused.add(std::nullopt);
  CHECK(refused.threshold(0.02).score == 0.0);
  CHECK(refused.threshold(1e-4).score == Approx(2.0));
}

TEST_CASE("a false score and a rate are checked", "[recognition]") {
  FalseScores scores;
  CHECK_THROWS_AS(scores.add(std::nan("")), InvalidValue);
  CHECK(scores.size() == 0);
  for (const double rate : {0.0, -0.1, 1.1, std::nan("")}) {
    CHECK_THROWS_AS(scores.threshold(rate), InvalidValue);
  }
}

TEST_CASE("false scores are made again of what they tell", "[recognition]") {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  FalseScores was;
  for (int i = 0; i < 100; ++i) {
    was.add(i % 4 == 0 ? std::nullopt : std::make_optional(normal(random)));
  }
  CHECK(was.scores().size() == 75);
  CHECK(std::is_sorted(was.scores().rbegin(), was.scores().rend()));
  std::vector<double> shuffled = was.scores();
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  const FalseScores is(was.size(), shuffled);
  CHECK(is.size() == 100);
  CHECK(is.scores() == was.scores());
  for (double s = -4.0; s < 8.0; s += 0.1) CHECK(is.rate(s).rate == was.rate(s).rate);
  CHECK_THROWS_AS(FalseScores(74, shuffled), InvalidValue);
  CHECK_THROWS_AS(FalseScores(1, {std::nan("")}), InvalidValue);
}
