// SPDX-License-Identifier: MIT
#include <topobag/adaptors/fleet/push.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/fleet/enlist_with_server.hpp>

#include "adaptors/fleet_robots.hpp"
#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// A server that keeps a fleet's hall, and nothing of it yet.
std::string empty_hall() {
  const std::string conninfo = shared_postgres().new_base();
  PostgresStore store(conninfo);
  store.prepare();
  store.add_site("hall", 0);
  return conninfo;
}

/// All of the hall, in the order in which the robot changed it.
std::vector<FleetVersion> versions_in_hall(const std::string& conninfo) {
  PostgresStore store(conninfo);
  FleetCursor cursor;
  std::vector<FleetVersion> all;
  for (auto page = store.read("hall", cursor, 1000); !page.empty();
       page = store.read("hall", cursor, 1000)) {
    for (ReadVersion& read : page) {
      CHECK(read.fault.empty());
      all.push_back(std::move(read.version));
    }
  }
  std::sort(all.begin(), all.end(),
            [](const FleetVersion& a, const FleetVersion& b) { return a.seq < b.seq; });
  return all;
}

void change_at_random(SimulatedRobot& robot, std::mt19937& random, std::size_t changes) {
  for (std::size_t i = 0; i < changes; ++i) {
    switch (random() % 4) {
      case 0:
        robot.update(random, random_graph(random, 4));
        break;
      case 1:
        robot.erase(random);
        break;
      default:
        robot.add(random, random_graph(random, 4));
    }
  }
}

}  // namespace

TEST_CASE("in whatever batches a map is pushed, the server has each change once", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  for (const std::size_t batch : {1U, 2U, 3U, 7U, 1000U}) {
    const ScratchFolder folder;
    const std::string conninfo = empty_hall();
    std::mt19937 random(static_cast<unsigned>(batch));
    SimulatedRobot robot(folder.path(), "hall", 0);
    std::vector<FleetVersion> pushed;  // of a key frame, what it was at each push
    for (int round = 0; round < 3; ++round) {
      change_at_random(robot, random, 12);
      const auto changes = robot.outbox().after(pushed.empty() ? 0 : pushed.back().seq, 1000);
      pushed.insert(pushed.end(), changes.begin(), changes.end());
      PostgresStore store(conninfo);  // a new connection, as after a restart
      CHECK(push(robot.outbox(), store, batch) == changes.size());
      CHECK(push(robot.outbox(), store, batch) == 0);
      const std::vector<FleetVersion> there = versions_in_hall(conninfo);
      REQUIRE(there.size() == pushed.size());
      for (std::size_t i = 0; i < pushed.size(); ++i) {
        CHECK(there[i].seq == pushed[i].seq);
        CHECK(there[i].key.keyframe == pushed[i].key.keyframe);
        CHECK(there[i].tombstone == pushed[i].tombstone);
        CHECK(there[i].graph == pushed[i].graph);
      }
    }
    CHECK(pushed.size() > 15);
  }
}

TEST_CASE("an old copy of a map is told from the latest", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const ScratchFolder folder;
  std::mt19937 random(4);
  const std::string conninfo = empty_hall();
  PostgresStore store(conninfo);
  const std::string path = folder.path("map.db"), old = folder.path("old.db");
  enlist(path, "hall", Uuid{5});
  SqliteBag<>(path).add(KeyframeId{1}, random_graph(random, 5));
  std::filesystem::copy_file(path, old);
  SqliteBag<>(path).add(KeyframeId{2}, random_graph(random, 5));
  push(FleetOutbox(path), store);
  const auto said = [&] { return error_text([&] { push(FleetOutbox(old), store); }); };
  CHECK_THAT(said(), Catch::Contains("an old copy"));
  SqliteBag<>(old).add(KeyframeId{2}, random_graph(random, 5));
  SqliteBag<>(old).add(KeyframeId{3}, random_graph(random, 5));
  CHECK_THAT(said(), Catch::Contains("a copy of the map is in use"));
  CHECK(push(FleetOutbox(path), store) == 0);
  CHECK(versions_in_hall(conninfo).size() == 2);
}
