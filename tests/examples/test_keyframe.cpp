// SPDX-License-Identifier: MIT
#include "keyframe.hpp"

#include "catch.hpp"

TEST_CASE("a key frame goes by its frame, and of a saved map by its session as well",
          "[examples]") {
  program::Keyframe keyframe;
  keyframe.idx = 30;
  CHECK(name_of(keyframe) == "idx 30");
  keyframe.saved = program::SavedEntry{97, {1, ""}};
  CHECK(name_of(keyframe) == "session 1, idx 30");
  keyframe.saved->session.name = "Tuesday";
  CHECK(name_of(keyframe) == "session 1 (Tuesday), idx 30");
}
