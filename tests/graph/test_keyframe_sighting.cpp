// SPDX-License-Identifier: MIT
#include <topobag/graph/keyframe_sighting.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a sighting of nothing is of no camera and knows no gravity", "[graph]") {
  const KeyframeSighting nothing;
  CHECK(nothing.stamp == 0.0);
  CHECK(nothing.nodes.empty());
  CHECK_FALSE(nothing.gravity);
  CHECK_FALSE(nothing.view.in_field({0.0, 0.0, 1.0}, 0.0, 5.0));
}
