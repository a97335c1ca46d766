// SPDX-License-Identifier: MIT
#include <numeric>

#include <topobag/evaluation/bootstrap.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("resamples draw n units, repeat with the seed and differ without", "[evaluation]") {
  const auto draws = [](std::uint64_t seed) {
    std::vector<std::vector<std::uint32_t>> all;
    for_each_resample(7, {50, seed}, [&](const auto& times) { all.push_back(times); });
    return all;
  };
  const auto all = draws(1);
  REQUIRE(all.size() == 50);
  for (const auto& times : all) CHECK(std::accumulate(times.begin(), times.end(), 0u) == 7u);
  CHECK(draws(1) == all);
  CHECK(draws(2) != all);
}

TEST_CASE("the draws are the same on every machine", "[evaluation]") {
  std::vector<std::uint32_t> first;
  for_each_resample(4, {1, 5489}, [&](const auto& times) { first = times; });
  // The engine's first values, from the C++ standard's seed: 14514284786278117030, …
  CHECK(first[14514284786278117030ull >> 62] > 0);
}

TEST_CASE("percentiles of a hand-made list", "[evaluation]") {
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  const auto interval = percentile_interval(values, 0.9);
  CHECK(interval->low == Approx(5.0));
  CHECK(interval->high == Approx(95.0));
  CHECK(percentile_interval({4.0})->low == 4.0);
  CHECK_FALSE(percentile_interval({}));
}

TEST_CASE("the interval of a mean covers it about as often as it says", "[evaluation]") {
  std::mt19937 random(15);
  std::normal_distribution<double> normal(3.0, 2.0);
  int covered = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<double> sample(60);
    for (double& x : sample) x = normal(random);
    std::vector<double> means;
    for_each_resample(60, {300, std::uint64_t(round)}, [&](const auto& times) {
      means.push_back(std::inner_product(times.begin(), times.end(), sample.begin(), 0.0) / 60.0);
    });
    const auto interval = percentile_interval(means, 0.9);
    covered += interval->low <= 3.0 && interval->high >= 3.0;
  }
  CHECK(covered > 250);
  CHECK(covered < 288);
}

TEST_CASE("the paired test against all exchanges", "[evaluation]") {
  const std::vector<double> a{0, 0, 1, 0, 0, 1, 0, 0, 0, 0};
  const std::vector<double> b{1, 1, 1, 1, 0, 0, 1, 1, 1, 1};
  // Eight differ, seven for b: of 2⁸ exchanges 2 · (1 + 8) are as uneven.
  const PairedTest test = paired_test(a, b, {100000, 3});
  CHECK(test.mean_difference == Approx(0.6));
  CHECK(test.p_value == Approx(18.0 / 256.0).epsilon(0.05));
  CHECK(paired_test(b, a, {100000, 3}).mean_difference == Approx(-0.6));
  CHECK(paired_test(a, b, {1000, 4}).p_value == paired_test(a, b, {1000, 4}).p_value);
}

TEST_CASE("equal methods do not differ; the least p-value is not 0", "[evaluation]") {
  CHECK(paired_test({1, 2, 3}, {1, 2, 3}).p_value == 1.0);
  CHECK(paired_test({}, {}).p_value == 1.0);
  const PairedTest test = paired_test(std::vector<double>(100, 0.0), std::vector<double>(100, 1.0));
  CHECK(test.p_value == Approx(1.0 / 1001.0));
}

TEST_CASE("without a difference, small p-values are rare", "[evaluation]") {
  std::mt19937 random(16);
  std::uniform_real_distribution<double> unit;
  int below = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<double> a(20);
    std::vector<double> b(20);
    for (double& x : a) x = unit(random);
    for (double& x : b) x = unit(random);
    below += paired_test(a, b, {400, std::uint64_t(round)}).p_value <= 0.1;
  }
  CHECK(below > 20);
  CHECK(below < 62);
}
