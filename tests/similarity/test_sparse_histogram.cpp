// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <random>

#include <topobag/similarity/sparse_histogram.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("votes are summed per word, ascending", "[similarity]") {
  const SparseHistogram h({{7, 1.0}, {3, 2.0}, {7, 0.5}, {5, 0.0}});
  CHECK(h.entries() == std::vector<SparseHistogram::Entry>{{3, 2.0}, {7, 1.5}});
  CHECK_FALSE(h.empty());
  CHECK(SparseHistogram({{5, 0.0}}).empty());
}

TEST_CASE("the order of the votes does not change the last bit", "[similarity]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> weight(0.0, 1.0);
  std::vector<SparseHistogram::Entry> votes;
  for (std::uint64_t i = 0; i < 200; ++i) votes.push_back({i % 7, weight(random)});
  const SparseHistogram first(votes);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(votes.begin(), votes.end(), random);
    CHECK(SparseHistogram(votes) == first);
  }
}

TEST_CASE("products and cosines on hand-computed numbers", "[similarity]") {
  const SparseHistogram a({{1, 3.0}, {2, 4.0}}), b({{2, 2.0}, {9, 1.0}}), c({{1, -1.0}});
  CHECK(dot(a, b) == 8.0);
  CHECK(a.normalized() == SparseHistogram({{1, 0.6}, {2, 0.8}}));
  CHECK(unit_cosine(a.normalized(), c.normalized()) == 0.0);
  CHECK(unit_cosine(a.normalized(), a.normalized()) == Approx(1.0));
  CHECK(dot(a, SparseHistogram{}) == 0.0);
  CHECK(SparseHistogram{}.normalized().empty());
}

TEST_CASE("lengths neither overflow nor underflow", "[similarity]") {
  const double huge = std::numeric_limits<double>::max();
  CHECK(SparseHistogram({{1, huge}}).normalized() == SparseHistogram({{1, 1.0}}));
  CHECK(SparseHistogram({{1, 1e-300}}).normalized() == SparseHistogram({{1, 1.0}}));
}
