// SPDX-License-Identifier: MIT
#include <random>

#include <topobag/matching/bearing_options.hpp>
#include <topobag/matching/match_bearings.hpp>

#include "catch.hpp"
#include "recognition/bearings_of.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

/// The match of a room's objects, each of a class of its own or nearly, with exact bearings.
BearingMatch match_by(const BearingOptions& bearings) {
  std::mt19937 random(8);
  const SyntheticRoom room(9, 9, 9);
  const TopologyGraph<> candidate = room.seen_from(random_camera(random));
  const TopologyGraph<> seen = room.seen_from(random_camera(random));
  return match_bearings(candidate, bearings_of(seen, random, 0.002), MatchOptions{}, bearings);
}

}  // namespace

TEST_CASE("no more triples are tried than the option says, and that is told", "[matching]") {
  const BearingMatch all = match_by({});
  REQUIRE_FALSE(all.poses.empty());
  REQUIRE(all.triples > 5);
  BearingOptions few;
  few.max_triples = 3;
  const BearingMatch cut = match_by(few);
  CHECK(cut.triples <= 3);
  CHECK_FALSE(cut.complete);
}

TEST_CASE("nothing beyond the range is matched", "[matching]") {
  BearingOptions near;
  near.max_range = 0.5;  // every object of the room is further away
  CHECK(match_by(near).poses.empty());
}

TEST_CASE("a pose less certain than the option says is degenerate", "[matching]") {
  REQUIRE_FALSE(match_by({}).poses.front().degenerate);
  BearingOptions strict;
  strict.max_translation_deviation = 1e-6;
  for (const RelativePose& pose : match_by(strict).poses) CHECK(pose.degenerate);
}
