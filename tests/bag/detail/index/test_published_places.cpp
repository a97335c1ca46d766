// SPDX-License-Identifier: MIT
#include <topobag/bag/detail/index/published_places.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("what places hold is copied for readers only when it has changed", "[bag]") {
  detail::PublishedPlaces places;
  const ClassCounts chairs{{ClassId{56}, 2}};
  EntryInfo info;  // of key frames that follow each other
  info.stamp = 0.0;
  const auto empty = places.contents();
  places.add(KeyframeId{1}, info, chairs);
  const auto one = places.contents();
  CHECK(one != empty);
  CHECK(empty->holding(chairs, {}, 5) == 1);          // at least one
  places.add(KeyframeId{2}, info, {{ClassId{56}, 1}});  // of the same place, with nothing new
  CHECK(places.contents() == one);

  detail::PublishedPlaces copy = places;
  CHECK(copy.contents() == one);
  copy.remove(KeyframeId{1}, info, chairs);
  CHECK(copy.contents() != one);
  CHECK(places.contents() == one);
  CHECK(copy.size() == 1);
}
