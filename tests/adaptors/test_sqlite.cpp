// SPDX-License-Identifier: MIT
#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "adaptors/sqlite_maps.hpp"
#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

using Bag = BagOfTopologyGraphs<>;

void add_all(SqliteBag<>& map, const Bag& bag, std::uint64_t first_id = 0) {
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    map.add(KeyframeId{value(id) + first_id}, graph, info);
  });
}

}  // namespace

TEST_CASE("a map on disk behaves like a bag in memory", "[sqlite]") {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const ScratchFolder folder;
    std::mt19937 random(seed);
    const std::string path = folder.path("map.db");
    const Bag source = random_bag(random, 20);
    std::vector<KeyframeId> ids;
    source.for_each([&](KeyframeId id, const auto&, const auto&) { ids.push_back(id); });
    std::optional<SqliteBag<>> map(std::in_place, path);
    Bag model;
    for (int step = 0; step < 150; ++step) {
      const KeyframeId id = ids[random() % ids.size()];
      const KeyframeId other = ids[random() % ids.size()];
      EntryInfo info = *source.info(other);
      const auto graph = *source.find(other);
      switch (random() % 5) {
        case 0:
        case 1:
          if (model.contains(id)) {
            CHECK_THROWS_AS(map->add(id, graph, info), InvalidId);
          } else {
            map->add(id, graph, info);
            model.add(id, decode(encode(graph)), *map->bag().info(id));
          }
          break;
        case 2:
          if (!model.contains(id)) {
            CHECK_THROWS_AS(map->update(id, graph, info), InvalidId);
          } else {
            map->update(id, graph, info);
            model.update(id, decode(encode(graph)), *map->bag().info(id));
          }
          break;
        case 3:
          CHECK(map->erase(id) == model.erase(id));
          break;
        default:
          map.emplace(path);
      }
      REQUIRE(saved(map->bag()) == saved(model));
      if (const auto kept = model.info(id)) {
        CHECK(kept->T_world_camera.has_value() == map->bag().info(id)->T_world_camera.has_value());
      }
    }
    const auto query = random_graph(random, 6, 80, false);
    CHECK(map->bag().query(query) == model.query(query));
  }
}

TEST_CASE("a label comes back whole, whatever letters it has", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  EntryInfo info;
  info.label = std::string("first\0second \xC3\xA4", 15);
  SqliteBag<>(path).add(KeyframeId{1}, TopologyGraph<>{}, info);
  CHECK(SqliteBag<>(path).bag().info(KeyframeId{1})->label == info.label);
}

TEST_CASE("a map keeps an indexed bag as well", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(6);
  const std::string path = folder.path("map.db");
  const Bag source = random_bag(random, 40);
  const ClassPairDistanceHistogram similarity;
  const auto query = random_graph(random, 8, 80, false);
  std::vector<Candidate> found;
  {
    SqliteBag<IndexedBag> map(path);
    BagOfTopologyGraphs<TopologyGraph<>, ClassPairDistanceHistogram> model(similarity);
    source.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
      map.add(id, graph, info);
      model.add(id, decode(encode(graph)), info);
      if (value(id) % 3 == 0) {
        map.update(id, query, info);
        model.update(id, decode(encode(query)), info);
      }
      if (value(id) % 5 == 1) CHECK(map.erase(id) == model.erase(id));
    });
    found = map.bag().query(query);
    CHECK(found == model.query(query));
    CHECK(found.front().similarity > 0.9);
  }
  const SqliteBag<IndexedBag> again(path, read_only());
  CHECK(again.bag().query(query) == found);
  const SqliteBag<> plain(path, read_only());
  CHECK(saved(plain.bag()) == saved(*again.bag().view()));
}

TEST_CASE("poses, stamps and labels come back", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(4);
  const Bag bag = random_bag(random, 30);
  const std::string path = folder.path("map.db");
  {
    SqliteBag<> map(path);
    add_all(map, bag, std::uint64_t{1} << 63);
  }
  const SqliteBag<> map(path, read_only());
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    const KeyframeId there{value(id) + (std::uint64_t{1} << 63)};
    REQUIRE(map.bag().contains(there));
    const EntryInfo back = *map.bag().info(there);
    CHECK(back.stamp == info.stamp);
    CHECK(back.session == info.session);
    CHECK(back.label == info.label);
    REQUIRE(back.T_world_camera.has_value() == info.T_world_camera.has_value());
    if (info.T_world_camera) {
      CHECK(back.T_world_camera->isApprox(*info.T_world_camera, 1e-12));
    }
    CHECK(encode(*map.bag().find(there)) == encode(graph));
  });
}

TEST_CASE("an old map is localized in read-only, then mapped on", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(5);
  const std::string path = folder.path("flat.db");
  const Bag monday = random_bag(random, 5), tuesday = random_bag(random, 7);
  {
    SqliteBag<> map(path);
    CHECK(map.begin_session("Monday") == 0);
    add_all(map, monday);
  }
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()),
                      std::filesystem::directory_iterator()) == 1);
  const std::string before = content_of(path);
  {
    SqliteBag<> map(path, read_only());
    CHECK(map.bag().size() == 5);
    CHECK(error_text([&] { map.add(KeyframeId{77}, {}); }) ==
          path + ": the map was opened for reading only");
    CHECK(error_text([&] { map.begin_session("x"); }) ==
          path + ": the map was opened for reading only");
    CHECK(map.bag().size() == 5);
  }
  CHECK(content_of(path) == before);
  {
    SqliteBag<> map(path);
    CHECK(map.begin_session("Tuesday") >= 1);
    add_all(map, tuesday, 500);
    CHECK(map.bag().size() == 12);
  }
  const SqliteBag<> map(path, read_only());
  CHECK(map.bag().size() == 12);
  REQUIRE(map.sessions().size() == 2);
  CHECK(map.sessions()[0].name == "Monday");
  CHECK(map.sessions()[1].name == "Tuesday");
}

TEST_CASE("the sqlite3 shell can read a map", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  SqliteOptions options;
  options.catalog = ClassCatalog::coco80();
  std::vector<SemanticNode<>> nodes(3);
  nodes[0].label = nodes[2].label = ClassId{62};
  nodes[1].label = ClassId{66};
  EntryInfo info;
  info.stamp = 12.5;
  info.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3));
  { SqliteBag<>(path, options).add(KeyframeId{9}, TopologyGraph<>(nodes), info); }
  CHECK(ask(path, "SELECT objects FROM keyframe WHERE id = 9") == "1 keyboard, 2 tv");
  CHECK(ask(path,
            "SELECT stamp || ' ' || tx || ' ' || tz || ' ' || qw || ' ' || nodes "
            "FROM keyframe") == "12.5 1.0 3.0 1.0 3");
  CHECK(ask(path, "SELECT name FROM class WHERE id = 62") == "tv");
  CHECK(ask(path, "PRAGMA user_version") == "1");
}

TEST_CASE("a map holds graphs with gravity and without", "[sqlite][gravity]") {
  const ScratchFolder folder;
  std::mt19937 random(9);
  const std::string path = folder.path("map.db");
  const TopologyGraph<> plain = random_graph(random, 5);
  const TopologyGraph<> graph(plain.nodes(), plain.edges(), {}, Gravity<>{{0, 0, 1}, 0.02});
  {
    SqliteBag<> map(path);
    map.add(KeyframeId{1}, plain);
    map.add(KeyframeId{2}, graph);
    map.add(KeyframeId{3}, graph);
    map.update(KeyframeId{3}, plain);
  }
  const SqliteBag<> map(path, read_only());
  CHECK_FALSE(map.bag().find(KeyframeId{1})->gravity());
  CHECK(map.bag().find(KeyframeId{2})->gravity()->down == Eigen::Vector3d::UnitZ());
  CHECK_FALSE(map.bag().find(KeyframeId{3})->gravity());
}
