// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <topobag/graph/scaled_graph.hpp>
#include <topobag/matching/detail/likely_scales.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

TEST_CASE("modes of scale votes are those of the triangles added up one by one", "[matching]") {
  std::mt19937 random(2205);
  const ScaleRange range{0.5, 2.0};
  std::uniform_real_distribution<double> log_scale(std::log(0.5), std::log(2.0)),
      deviation(0.06, 0.4), weight(0.1, 1.0);
  for (int round = 0; round < 30; ++round) {
    struct Vote {
      double log_scale, deviation, weight;
    };
    std::vector<Vote> votes;
    detail::ScaleVotes sums(range);
    for (int i = 0; i < 40; ++i) {
      const double x = log_scale(random), s = deviation(random), w = weight(random);
      votes.push_back({x, s, w});
      sums.add(x, s, w);
    }
    const auto density = [&](double at) {
      double sum = 0.0;
      for (const Vote& vote : votes) {
        const double half = std::min(2.0 * vote.deviation, 0.94);
        sum += vote.weight / half * std::max(0.0, 1.0 - std::abs(at - vote.log_scale) / half);
      }
      return sum;
    };
    double highest = 0.0;
    for (double at = std::log(0.5); at <= std::log(2.0); at += 0.005) {
      highest = std::max(highest, density(at));
    }
    const std::vector<double> modes = sums.modes(3);
    REQUIRE_FALSE(modes.empty());
    CHECK(modes.size() <= 3);
    CHECK(density(std::log(modes.front())) > 0.9 * highest);  // bins are 2 % wide
  }
}

TEST_CASE("a true scale is among the likely ones", "[matching]") {
  std::mt19937 random(2206);
  std::uniform_real_distribution<double> log_scale(std::log(0.3), std::log(3.3));
  const ConsistencyOptions options;
  const ScaleRange range;
  for (int round = 0; round < 100; ++round) {
    const double scale = std::exp(log_scale(random));
    const TopologyGraph<> place = noisy_graph(random, 7, 3, 0.02);
    const TopologyGraph<> query = scaled(jittered(random, place, 1.0), 1.0 / scale);
    const auto likely =
        detail::likely_scales(jittered(random, place, 1.0),
                              detail::KnownDistances<double>(query, options.noise), options, range);
    CAPTURE(round, scale);
    CHECK(likely.size() <= range.max_tried);
    CHECK(std::any_of(likely.begin(), likely.end(),
                      [&](double s) { return std::abs(std::log(s / scale)) < 0.05; }));
  }
}

TEST_CASE("no scale is likely where no two pairs of objects tell one", "[matching]") {
  const ConsistencyOptions options;
  const auto likely = [&](const TopologyGraph<>& candidate, const TopologyGraph<>& query) {
    return detail::likely_scales(candidate, detail::KnownDistances<double>(query, options.noise),
                                 options, ScaleRange{});
  };
  const TopologyGraph<> two({object_at(1, {0.0, 0.0, 2.0}), object_at(2, {1.0, 0.0, 2.0})});
  CHECK(likely(two, two).size() == 1);
  CHECK(likely(two, two).front() == Approx(1.0).epsilon(0.02));
  CHECK(likely(two, TopologyGraph<>({object_at(1, {0.0, 0.0, 2.0})})).empty());
  CHECK(likely(two, TopologyGraph<>{}).empty());
  CHECK(likely(two, TopologyGraph<>({object_at(3, {0.0, 0.0, 2.0}), object_at(4, {1.0, 0.0, 2.0})}))
            .empty());
  CHECK(likely(two, scaled(two, 10.0)).empty());  // out of range
  const TopologyGraph<> coincident({object_at(1, {0.0, 0.0, 2.0}), object_at(2, {0.0, 0.0, 2.0})});
  CHECK(likely(coincident, two).empty());
}
