// SPDX-License-Identifier: MIT
#include <map>
#include <random>
#include <vector>

#include <topobag/matching/detail/few_keys.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("few keys are what a map is, in the order in which they came", "[matching]") {
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    detail::FewKeys<int, int> few;
    std::map<int, int> map;
    std::vector<int> order;
    for (int i = 0; i < 40; ++i) {
      const int key = static_cast<int>(random() % 12);
      const auto [value, is_new] = few.insert(key);
      CHECK(is_new == (map.count(key) == 0));
      if (is_new) order.push_back(key);
      value += i;
      map[key] += i;
      CHECK(few[key] == map[key]);
    }
    std::vector<int> keys;
    for (const auto& [key, value] : few) {
      CHECK(value == map[key]);
      keys.push_back(key);
    }
    CHECK(keys == order);
  }
}
