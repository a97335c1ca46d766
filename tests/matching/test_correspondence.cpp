// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include <topobag/matching/correspondence.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("correspondences sort by query node, then candidate node", "[matching]") {
  const auto pair = [](std::size_t candidate, std::size_t query) {
    return Correspondence{node_index(candidate), node_index(query)};
  };
  std::vector<Correspondence> pairs{pair(0, 2), pair(5, 1), pair(4, 1), pair(9, 0)};
  std::sort(pairs.begin(), pairs.end());
  CHECK(pairs == std::vector<Correspondence>{pair(9, 0), pair(4, 1), pair(5, 1), pair(0, 2)});
  CHECK_FALSE(pair(1, 2) == pair(2, 1));
  CHECK_FALSE(pair(1, 2) < pair(1, 2));
}
