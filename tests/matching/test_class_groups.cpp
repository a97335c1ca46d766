// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/matching/class_groups.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("every class is alone in its group until joined", "[matching]") {
  const ClassGroups groups;
  CHECK(groups.group(ClassId{5}) == ClassId{5});
  CHECK(groups.compatible(ClassId{5}, ClassId{5}));
  CHECK_FALSE(groups.compatible(ClassId{5}, ClassId{6}));
}

TEST_CASE("joining is symmetric and transitive", "[matching]") {
  std::mt19937 random(61);
  for (int round = 0; round < 200; ++round) {
    constexpr std::size_t n = 8;
    std::vector<std::size_t> of(n);  // the reference: a number per class, rewritten at each joint
    for (std::size_t i = 0; i < n; ++i) of[i] = i;
    ClassGroups groups;
    for (int joint = 0; joint < 5; ++joint) {
      const std::size_t a = random() % n, b = random() % n;
      groups.join(ClassId{static_cast<int>(a)}, ClassId{static_cast<int>(b)});
      const std::size_t from = of[b], to = of[a];
      for (std::size_t& number : of) number = number == from ? to : number;
    }
    for (std::size_t i = 0; i < n; ++i) {
      std::size_t smallest = 0;
      while (of[smallest] != of[i]) ++smallest;
      CHECK(groups.group(ClassId{static_cast<int>(i)}) == ClassId{static_cast<int>(smallest)});
      for (std::size_t j = 0; j < n; ++j) {
        CHECK(groups.compatible(ClassId{static_cast<int>(i)}, ClassId{static_cast<int>(j)}) ==
              (of[i] == of[j]));
      }
    }
  }
}

TEST_CASE("a tv may be a laptop where the catalog has both", "[matching]") {
  const ClassCatalog coco = ClassCatalog::coco80();
  const ClassGroups groups = lookalike_classes(coco);
  CHECK(groups.compatible(coco.at("tv"), coco.at("laptop")));
  CHECK_FALSE(groups.compatible(coco.at("tv"), coco.at("chair")));

  ClassCatalog no_laptop;
  no_laptop.add(ClassId{1}, "tv", Dynamics::low);
  CHECK(lookalike_classes(no_laptop).group(ClassId{1}) == ClassId{1});
}
