// SPDX-License-Identifier: MIT
#include <topobag/recognition/map_alignment.hpp>

#include <set>
#include <string>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("every verdict on two maps says its own reason", "[recognition]") {
  std::set<std::string> reasons;
  for (const auto verdict :
       {AlignmentVerdict::aligned, AlignmentVerdict::no_poses, AlignmentVerdict::too_few,
        AlignmentVerdict::ambiguous, AlignmentVerdict::contradicted}) {
    reasons.insert(why(verdict));
  }
  CHECK(reasons.size() == 5);
  CHECK(reasons.count("") == 0);
  CHECK_FALSE(MapAlignment{});
}
