// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

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
        "the entry's stamp is not finite");
  CHECK(error_text([&] { bag.update(KeyframeId{7}, Graph{}, bad); }) ==
        "the entry's stamp is not finite");
  CHECK(bag.size() == 1);
  CHECK_FALSE(bag.info(KeyframeId{7})->stamp);
  CHECK_FALSE(bag.find(KeyframeId{8}));
  CHECK_FALSE(bag.info(KeyframeId{8}));
  CHECK_FALSE(bag.erase(KeyframeId{8}));
}
