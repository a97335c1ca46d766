// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>

#include <topobag/bag/indexed_bag.hpp>
#include <topobag/bag/session_number.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

TEST_CASE("sessions are numbered on and never from the start again", "[bag]") {
  constexpr std::uint32_t last = std::numeric_limits<std::uint32_t>::max();
  CHECK(next_session(std::nullopt) == 0);
  CHECK(next_session(6) == 7);
  CHECK(next_session(last - 1) == last);
  CHECK(error_text([&] { next_session(last); }) ==
        "the numbers of sessions are used up: there are 2^32");
  CHECK(session_after(3, 4) == 7);
  CHECK_THROWS_AS(session_after(1, last), InvalidId);
}

TEST_CASE("a merge does not let a session wrap around, nor a mirror in", "[bag]") {
  IndexedBag ours, theirs;
  EntryInfo info;
  info.session = 2;
  theirs.add(KeyframeId{1}, TopologyGraph<>(), info);
  MergeOptions options;
  options.session_offset = std::numeric_limits<std::uint32_t>::max() - 1;
  CHECK_THROWS_AS(ours.merge(*theirs.view(), options), InvalidId);
  options.session_offset = 0;
  options.T_world_other = Eigen::Isometry3d::Identity();
  options.T_world_other->linear() *= 0.5;
  CHECK_THROWS_AS(ours.merge(*theirs.view(), options), InvalidValue);
  CHECK(ours.empty());
}
