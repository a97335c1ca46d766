// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/matching/detail/chosen_pairs.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

TEST_CASE("chosen pairs are those at the positions chosen, in their order", "[matching]") {
  std::vector<PointPair> all;
  for (int i = 0; i < 5; ++i) {
    auto node = object_at(1, Eigen::Vector3d(i, 0, 3));
    node.size = {0.4, 0.4};
    all.push_back(point_pair(node, node));
  }
  const std::vector<std::size_t> chosen{1, 4, 2};
  const detail::ChosenPairs<> pairs(all, chosen);
  const detail::ChosenPairs<true> alike(all, chosen);
  REQUIRE(pairs.size() == 3);
  REQUIRE(alike.size() == 3);
  std::mt19937 random(931);
  const Eigen::Isometry3d T = random_motion(random, 1.0);
  std::size_t i = 0;
  for (const auto& pair : pairs) {
    CHECK(&pair == &all[chosen[i]]);
    CHECK(&pairs[i] == &pair);
    ++i;
  }
  CHECK(i == 3);
  i = 0;
  for (const auto& pair : alike) {
    CHECK(pair.covariance(T) == all[chosen[i]].seen_alike().covariance(T));
    CHECK_FALSE(pair.covariance(T) == all[chosen[i]].covariance(T));
    ++i;
  }
  CHECK(i == 3);
}

TEST_CASE("of no positions no pairs are chosen", "[matching]") {
  const std::vector<PointPair> all;
  const std::vector<std::size_t> chosen;
  const detail::ChosenPairs<> pairs(all, chosen);
  CHECK(pairs.size() == 0);
  CHECK_FALSE(pairs.begin() != pairs.end());
}
