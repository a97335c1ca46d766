// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <topobag/bag/entry_info.hpp>

#include "catch.hpp"
#include "error_text.hpp"

/// What every bag refuses, in the same words, and that it changes nothing.
template <typename Bag>
void check_refusals() {
  using topobag::KeyframeId;
  using Graph = typename Bag::Graph;
  Bag bag;
  bag.add(KeyframeId{7}, Graph{});
  topobag::EntryInfo bad;
  bad.stamp = std::nan("");
  CHECK(error_text([&] { bag.add(KeyframeId{7}, Graph{}); }) ==
        "key frame 7 is in the bag already: use update");
  CHECK(error_text([&] { bag.update(KeyframeId{8}, Graph{}); }) ==
        "key frame 8 is not in the bag: use add");
  CHECK(error_text([&] { bag.add(KeyframeId{8}, Graph{}, bad); }) ==
        "the time stamp is not finite");
  CHECK(error_text([&] { bag.update(KeyframeId{7}, Graph{}, bad); }) ==
        "the time stamp is not finite");
  topobag::EntryInfo mirrored;
  mirrored.T_world_camera = Eigen::Isometry3d::Identity();
  mirrored.T_world_camera->linear().diagonal().z() = -1.0;
  const std::string mirrors =
      "the entry's pose is no rigid motion: it mirrors; one of the two frames is left-handed";
  CHECK(error_text([&] { bag.add(KeyframeId{8}, Graph{}, mirrored); }) == mirrors);
  CHECK(error_text([&] { bag.update(KeyframeId{7}, Graph{}, mirrored); }) == mirrors);
  using Node = typename Graph::Node;
  const Graph crowd(std::vector<Node>(4097));
  CHECK(error_text([&] { bag.add(KeyframeId{8}, crowd); }) ==
        "a graph of 4097 nodes; a map keeps up to 4096");
  CHECK(error_text([&] { bag.update(KeyframeId{7}, crowd); }) ==
        "a graph of 4097 nodes; a map keeps up to 4096");
  CHECK(bag.size() == 1);
  CHECK_FALSE(bag.info(KeyframeId{7})->stamp);
  CHECK_FALSE(bag.find(KeyframeId{8}));
  CHECK_FALSE(bag.info(KeyframeId{8}));
  CHECK_FALSE(bag.erase(KeyframeId{8}));
}

/// That a walk shows every entry that was there when it began, whatever it does to the bag.
template <typename Bag>
void check_walk_that_changes_the_bag() {
  using topobag::KeyframeId;
  using Graph = typename Bag::Graph;
  Bag bag;
  for (std::uint64_t id = 0; id < 1000; ++id) bag.add(KeyframeId{id}, Graph{});
  std::vector<std::uint64_t> seen;
  bag.for_each([&](KeyframeId id, const topobag::EntryInfo& info, const Graph& graph) {
    const std::uint64_t number = topobag::value(id);
    seen.push_back(number);
    if (number % 2 == 0) bag.erase(KeyframeId{number + 1});  // the next one
    if (number % 3 == 0) bag.erase(id);
    if (number == 10) bag.add(KeyframeId{5000}, Graph{});
    CHECK(graph.size() == 0);
    CHECK(info.session == 0);
  });
  REQUIRE(seen.size() == 1000);
  for (std::uint64_t id = 0; id < 1000; ++id) CHECK(seen[id] == id);
  CHECK(bag.size() == 334);
  bag.for_each([&](KeyframeId, const topobag::EntryInfo&, const Graph&) { bag.clear(); });
  CHECK(bag.empty());
}
