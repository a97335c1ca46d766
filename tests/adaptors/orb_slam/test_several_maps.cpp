// SPDX-License-Identifier: MIT
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("a lost camera is found in its map, whatever another one holds", "[adaptors]") {
  std::size_t found = 0, found_alone = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    atlas_host::Session lost_in(seed);
    atlas_host::KeyFrame& here = lost_in.mapped(0.0, lost_in.first);
    atlas_host::Frame frame{random_camera(lost_in.random)};
    const auto candidates = [&] {
      return lost_in.database.DetectRelocalizationCandidates(&frame, &lost_in.first);
    };
    if (candidates() == atlas_host::Pointers{&here}) ++found_alone;
    for (int i = 0; i < 8; ++i) lost_in.mapped(100.0 + 10.0 * i, lost_in.second);
    if (candidates() == atlas_host::Pointers{&here}) ++found;
  }
  CHECK(found_alone == 50);
  CHECK(found == 50);
}

TEST_CASE("merges are found beside any number of loops, and loops beside merges", "[adaptors]") {
  std::size_t merged = 0, looped = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    atlas_host::Session session(seed);
    const bool many_here = seed % 2 == 0;
    atlas_host::Map& many = many_here ? session.first : session.second;
    atlas_host::Map& one = many_here ? session.second : session.first;
    atlas_host::KeyFrame& sought = session.mapped(0.0, one);
    for (int i = 0; i < 8; ++i) session.mapped(10.0 * i, many);
    atlas_host::KeyFrame& now = session.mapped(150.0, session.first);
    atlas_host::Pointers loops, merges;
    session.database.DetectNBestCandidates(&now, loops, merges, 3);
    CHECK(loops.size() <= 3);
    CHECK(merges.size() <= 3);
    CHECK_FALSE(loops.empty());
    CHECK_FALSE(merges.empty());
    for (const auto* key_frame : loops) CHECK(key_frame->map == &session.first);
    for (const auto* key_frame : merges) CHECK(key_frame->map == &session.second);
    (many_here ? merged : looped) += (many_here ? merges : loops) == atlas_host::Pointers{&sought};
  }
  CHECK(merged == 10);
  CHECK(looped == 10);
}

TEST_CASE("the own map's last seconds take no slot, another map's may be a second old",
          "[adaptors]") {
  atlas_host::Session session(3);
  atlas_host::KeyFrame& old = session.mapped(0.0, session.first);
  atlas_host::KeyFrame& other = session.mapped(99.0, session.second);
  for (int i = 0; i < 6; ++i) session.mapped(85.0 + 2.0 * i, session.first);
  atlas_host::KeyFrame& now = session.mapped(100.0, session.first);
  atlas_host::Pointers loops, merges;
  session.database.DetectNBestCandidates(&now, loops, merges, 3);
  CHECK(loops == atlas_host::Pointers{&old});
  CHECK(merges == atlas_host::Pointers{&other});
}

TEST_CASE("bad key frames take no slot of a good one", "[adaptors]") {
  atlas_host::Session session(4);
  atlas_host::KeyFrame& good = session.mapped(0.0, session.first);
  for (int i = 1; i < 8; ++i) session.mapped(10.0 * i, session.first).bad = true;
  atlas_host::Frame frame{random_camera(session.random)};
  CHECK(session.database.DetectRelocalizationCandidates(&frame) == atlas_host::Pointers{&good});
}
