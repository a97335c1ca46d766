// SPDX-License-Identifier: MIT
#include <random>
#include <string>

#include <topobag/adaptors/fleet/fleet_outbox.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

TEST_CASE("an outbox tells the last change of each key frame, in order", "[fleet]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  std::mt19937 random(1);
  const auto graph = random_graph(random, 5), moved = random_graph(random, 4);
  { SqliteBag<>(path).add(KeyframeId{1}, graph); }
  enlist(path, "hall", Uuid{7});
  enlist(path, "hall");  // again changes nothing
  SqliteBag<> map(path);
  const FleetOutbox outbox(path);
  CHECK(outbox.member().site == "hall");
  CHECK(outbox.member().robot == Uuid{7});
  REQUIRE(outbox.after(0, 10).size() == 1);  // what was there before is told as well

  map.add(KeyframeId{2}, graph);
  map.update(KeyframeId{1}, moved);
  map.erase(KeyframeId{2});
  EntryInfo other_session;
  other_session.session = 1;
  map.add(KeyframeId{3}, graph);
  map.update(KeyframeId{3}, graph, other_session);
  const auto versions = outbox.after(0, 10);
  REQUIRE(versions.size() == 4);
  CHECK(versions[0].key.keyframe == KeyframeId{1});
  CHECK(versions[0].graph == encode(moved));
  CHECK(versions[1].key.keyframe == KeyframeId{2});
  CHECK(versions[1].tombstone);
  CHECK(versions[2].tombstone);  // it has left its first session
  CHECK_FALSE(versions[3].tombstone);
  CHECK(versions[3].key.keyframe == KeyframeId{3});
  CHECK(versions[2].key.session != versions[3].key.session);
  CHECK(outbox.sessions().size() == 2);
  for (std::size_t i = 1; i < 4; ++i) CHECK(versions[i - 1].seq < versions[i].seq);
  CHECK(outbox.last_seq() == versions[3].seq);
  CHECK(outbox.count_after(versions[1].seq) == 2);
  CHECK(outbox.after(versions[1].seq, 1).size() == 1);
}

TEST_CASE("a map is one robot's at one site", "[fleet]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  { const SqliteBag<> map(path); }
  CHECK_THROWS_AS(FleetOutbox(path), FormatError);
  CHECK_THROWS_AS(enlist(path, ""), InvalidValue);
  CHECK_THROWS_AS(enlist(path, std::string("a\0b", 3)), InvalidValue);
  enlist(path, "hall", Uuid{1});
  CHECK_THROWS_AS(enlist(path, "yard", Uuid{1}), InvalidId);
  CHECK_THROWS_AS(enlist(path, "hall", Uuid{2}), InvalidId);
  CHECK(FleetOutbox(path).after(0, 10).empty());
}
