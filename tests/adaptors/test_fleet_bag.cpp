// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <topobag/adaptors/fleet_bag.hpp>
#include <topobag/bag/bag_concepts.hpp>
#include <topobag/recognition/calibrate.hpp>

#include "adaptors/postgres_server.hpp"
#include "bag/reading_calls.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// A site's server, ready.
std::string fleet_base(std::vector<std::string> sites = {"hall"}) {
  const std::string conninfo = shared_postgres().new_base();
  PostgresStore store(conninfo);
  store.prepare();
  for (const std::string& site : sites) store.add_site(site, 0);
  return conninfo;
}

}  // namespace

TEST_CASE("a fleet's bag has every reading call, and is asked by whoever asks bags", "[fleet]") {
  CHECK(missing_calls_of<FleetBag>() == "");
  STATIC_REQUIRE(is_searchable_bag_v<FleetBag>);
  STATIC_REQUIRE_FALSE(is_stored_bag_v<FleetBag>);  // its ids mean nothing outside of it
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(3);
  const std::string conninfo = fleet_base();
  PostgresStore store(conninfo);
  for (std::uint8_t i = 0; i < 12; ++i) {
    FleetVersion version =
        version_of({"hall", Uuid{1}, Uuid{1}, KeyframeId{i}}, {}, random_graph(random, 8));
    version.seq = i + 1;
    store.append({version});
  }
  FleetBag fleet({{conninfo, {"hall"}}});
  CHECK(fleet.empty());
  fleet.follow();
  std::vector<KeyframeId> ids;
  fleet.for_each([&](const FleetKey&, const EntryInfo&, const TopologyGraph<>&) {
    ids.push_back(fleet.query(*fleet.find(KeyframeId{ids.size()})).front().id);
  });
  REQUIRE(ids.size() == 12);
  CHECK(std::is_sorted(ids.begin(), ids.end()));
  const Relocalizer relocalizer(fleet);
  CalibrateOptions options;
  options.null_queries = 12;
  CHECK(calibrate(relocalizer, ids, {}, options).queries() == 12);
}

TEST_CASE("what a robot pushes is in every follower's bag", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const ScratchFolder folder;
  const std::string conninfo = fleet_base();
  std::mt19937 random(1);
  const Uuid robot = random_uuid();
  enlist(folder.path("map.db"), "hall", robot);
  SqliteBag<> map(folder.path("map.db"));
  EntryInfo info;
  info.session = map.begin_session("Monday");
  info.stamp = 1.5;
  info.label = std::string("a\0b'; DROP TABLE topobag.version; --", 36);
  info.T_world_camera = Eigen::Isometry3d(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
  const std::uint64_t great = 0xFFFFFFFF00000001;
  map.add(KeyframeId{great}, random_graph(random, 8), info);
  map.add(KeyframeId{2}, random_graph(random, 8), info);

  PostgresStore store(conninfo);
  const FleetOutbox outbox(folder.path("map.db"));
  FleetBag fleet({{conninfo, {"hall"}}});
  CHECK(fleet.follow() == 0);
  CHECK(push(outbox, store) == 2);
  CHECK(push(outbox, store) == 0);
  CHECK(fleet.wait());
  CHECK(fleet.follow() == 2);
  CHECK(fleet.follow() == 0);
  const auto view = fleet.view();
  REQUIRE(view->size() == 2);
  const auto found = view->query(*map.bag().find(KeyframeId{great}));
  REQUIRE(found.size() == 2);
  CHECK(found.front().similarity > 0.99);
  const FleetKey key = view->key(found.front().id);
  CHECK(key.site == "hall");
  CHECK(key.robot == robot);
  CHECK(key.keyframe == KeyframeId{great});
  CHECK(view->sessions().front().run == "Monday");
  CHECK(view->info(found.front().id)->label == info.label);
  CHECK(view->info(found.front().id)->stamp == info.stamp);
  CHECK(view->info(found.front().id)->T_world_camera->matrix() ==
        map.bag().info(KeyframeId{great})->T_world_camera->matrix());

  map.erase(KeyframeId{2});
  info.stamp = 2.5;
  map.update(KeyframeId{great}, random_graph(random, 3), info);
  CHECK(push(outbox, store) == 2);
  CHECK(fleet.follow() == 2);
  CHECK(fleet.size() == 1);
  CHECK(fleet.view()->info(found.front().id)->stamp == 2.5);
  CHECK(view->size() == 2);
  CHECK(fleet.refused().empty());
}

TEST_CASE("readers ask a fleet's bag while it follows", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(2);
  const std::string conninfo = fleet_base();
  PostgresStore store(conninfo);
  const auto graph = random_graph(random, 6);
  std::atomic<bool> done{false}, sound{true};
  std::atomic<std::size_t> asked{0};
  FleetBag fleet({{conninfo, {"hall"}}});
  std::thread reader([&] {
    for (; !done; ++asked) {
      const auto view = fleet.view();
      for (const Candidate& candidate : view->query(graph)) {
        const FleetKey key = view->key(candidate.id);  // of every entry that the view shows
        if (key.site != "hall" || value(key.keyframe) != key.session[0]) sound = false;
      }
    }
  });
  for (std::uint8_t session = 0; session < 60; ++session) {
    FleetVersion version =
        version_of({"hall", Uuid{1}, Uuid{session}, KeyframeId{session}}, {}, graph);
    version.seq = 1;
    store.append({version});
    fleet.follow();
  }
  while (asked == 0) std::this_thread::yield();
  done = true;
  reader.join();
  CHECK(sound);
  CHECK(fleet.size() == 60);
}
