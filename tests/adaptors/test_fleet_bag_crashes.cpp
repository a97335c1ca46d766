// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "child_process.hpp"
#include "long_rounds.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// Calls until it does not throw: the server is about to come back.
template <typename Call>
void insist(const Call& call) {
  for (;;) {
    try {
      return call();
    } catch (const Error&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
}

/// The key frames of a view where they are 0, 1, … without a gap, each as it was pushed.
std::optional<std::uint64_t> whole_prefix(const FleetView& view,
                                          const std::vector<TopologyGraph<>>& graphs) {
  std::uint64_t next = 0;
  bool sound = true;
  view.for_each([&](const FleetKey& key, const EntryInfo&, const TopologyGraph<>& graph) {
    sound = sound && value(key.keyframe) == next &&
            encode(graph) == encode(graphs[next % graphs.size()]);
    ++next;
  });
  if (!sound) return std::nullopt;
  return next;
}

/// A robot that adds key frames, pushes each, and tells of it when the server has acknowledged it.
void push_for_ever(const std::string& path, const std::string& conninfo,
                   const std::vector<TopologyGraph<>>& graphs,
                   const std::function<void(std::uint64_t)>& tell) {
  SqliteBag<> map(path);
  const FleetOutbox outbox(path);
  PostgresStore store(conninfo);
  for (;;) {
    insist([&] { push(outbox, store, 3); });
    const std::uint64_t id = map.bag().size();
    if (id > 0) tell(id);
    for (std::uint64_t more = 0; more < 1 + id % 5; ++more) {
      map.add(KeyframeId{id + more}, graphs[(id + more) % graphs.size()]);
    }
  }
}

/// What a follower tells when it has skipped or doubled a key frame.
constexpr std::uint64_t gap = ~std::uint64_t{0};

/// A follower that tells how many key frames it has, or that they are not the first ones.
void follow_for_ever(const std::string& conninfo, const std::vector<TopologyGraph<>>& graphs,
                     const std::function<void(std::uint64_t)>& tell) {
  FleetBag fleet({{conninfo, {"hall"}}});
  for (;;) {
    insist([&] { fleet.follow(); });
    tell(whole_prefix(*fleet.view(), graphs).value_or(gap));
    fleet.wait(std::chrono::milliseconds(20));
  }
}

/// Kills a robot and a follower in each round, and the server in every third, at any moment.
void kill_them(unsigned rounds) {
  std::mt19937 random(5);
  std::vector<TopologyGraph<>> graphs;
  for (int i = 0; i < 30; ++i) graphs.push_back(random_graph(random, 6));
  PostgresServer server;
  std::optional<ScratchFolder> folder;
  std::string conninfo;
  std::optional<FleetBag> survivor;
  std::uint64_t acknowledged = 0, followed = 0;
  unsigned crashes = 0;
  for (unsigned round = 0; round < rounds; ++round) {
    if (round % 30 == 0) {
      folder.emplace();
      conninfo = server.new_base();
      PostgresStore store(conninfo);
      store.prepare();
      store.add_site("hall", 0);
      enlist(folder->path("map.db"), "hall", random_uuid());
      survivor.emplace(std::vector<FleetSource>{{conninfo, {"hall"}}});
      acknowledged = 0;
    }
    ChildProcess robot(
        [&](const auto& tell) { push_for_ever(folder->path("map.db"), conninfo, graphs, tell); });
    ChildProcess follower([&](const auto& tell) { follow_for_ever(conninfo, graphs, tell); });
    if (round % 2 == 0) acknowledged = robot.told().value();  // however slow the machine
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 60000));
    const auto victim = random() % 3;
    if (victim == 0) {
      server.crash();
      server.start();
      ++crashes;
      insist([&] { survivor->follow(); });
    } else if (victim == 1) {
      follower.kill();
      insist([&] { survivor->follow(); });
    }
    robot.kill();  // the last it did may be on its way yet
    while (const auto told = robot.told()) acknowledged = *told;
    if (victim != 1) follower.kill();
    while (const auto told = follower.told()) {
      REQUIRE(*told != gap);
      followed = std::max(followed, *told);
    }
    // When the server has ended what the killed had begun, its rows are final.
    server.sql(
        "SELECT pg_terminate_backend(pid, 10000) FROM pg_stat_activity WHERE"
        " pid <> pg_backend_pid() AND backend_type = 'client backend'");
    const std::uint64_t rows =
        std::stoull(server.sql("SELECT count(*) FROM topobag.version", conninfo));
    REQUIRE(rows >= acknowledged);
    REQUIRE(std::stoull(server.sql("SELECT count(DISTINCT keyframe) FROM topobag.version",
                                   conninfo)) == rows);
    insist([&] { survivor->follow(); });
    REQUIRE(whole_prefix(*survivor->view(), graphs) == rows);
    FleetBag fresh({{conninfo, {"hall"}}});
    CHECK(fresh.follow() == rows);
  }
  CHECK(followed > 0);
  CHECK(crashes > 0);
}

}  // namespace

TEST_CASE("a kill loses no acknowledged key frame and doubles none", "[fleet]") {
  if (PostgresServer::is_installed()) kill_them(6);
}

TEST_CASE("300 kills of a robot and of a follower, with the server's, lose and double nothing",
          "[fleet][long]") {
  if (PostgresServer::is_installed()) kill_them(long_rounds(300));
}
