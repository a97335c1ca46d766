// SPDX-License-Identifier: MIT
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "pair_times.hpp"

TEST_CASE("a share of values lies below its quantile", "[benchmarks]") {
  const std::vector<double> values{5.0, 1.0, 4.0, 2.0, 3.0};
  CHECK(bench::share(values, 0.0) == 1.0);
  CHECK(bench::share(values, 0.5) == 3.0);
  CHECK(bench::share(values, 1.0) == 5.0);
  CHECK(bench::mean(values) == 3.0);
}

TEST_CASE("pairs are spread over all, none twice, no more than asked", "[benchmarks]") {
  for (const std::size_t most : {1U, 7U, 34U, 35U, 1000U}) {
    const auto pairs = bench::spread_pairs(5, 7, most);
    const std::set<std::pair<std::size_t, std::size_t>> different(pairs.begin(), pairs.end());
    CHECK(different.size() == pairs.size());
    CHECK(pairs.size() <= most);
    if (most >= 35) CHECK(pairs.size() == 35);
    for (const auto& pair : pairs) {
      CHECK(pair.first < 5);
      CHECK(pair.second < 7);
    }
  }
  CHECK_THROWS(bench::spread_pairs(0, 7, 10));
}

TEST_CASE("each pair is called three times", "[benchmarks]") {
  std::vector<int> calls(4, 0);
  const auto times = bench::times_of(std::vector<std::size_t>{0, 1}, std::vector<std::size_t>{0, 2},
                                     100, [&](std::size_t p, std::size_t q) { ++calls[p + q]; });
  CHECK(times.size() == 4);
  CHECK(calls == std::vector<int>{3, 3, 3, 3});
}
