// SPDX-License-Identifier: MIT
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "child_process.hpp"
#include "error_text.hpp"
#include "long_rounds.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

using Bag = BagOfTopologyGraphs<>;

void add_all(SqliteBag<>& map, const Bag& bag, std::uint64_t first_id = 0) {
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    map.add(KeyframeId{value(id) + first_id}, graph, info);
  });
}

SqliteOptions read_only() {
  SqliteOptions options;
  options.read_only = true;
  return options;
}

/// What the first row of an SQL query says.
std::string ask(const std::string& path, const std::string& sql) {
  const detail::SqliteConnection connection(path, false);
  detail::SqliteStatement statement(connection, sql);
  return statement.step() ? statement.text(0) : "no row";
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
    CHECK(found.front().score > 0.9);
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

TEST_CASE("files that are no map of ours are refused and stay as they are", "[sqlite]") {
  const ScratchFolder folder;
  const std::string text = folder.write("text.db", std::string(5000, 'x'));
  CHECK(error_text([&] { SqliteBag<> map(text); }) ==
        text + ": file is not a database; take another copy");
  const std::string foreign = folder.path("foreign.db");
  detail::SqliteConnection(foreign, false).run("CREATE TABLE photos(id)");
  const std::string before = content_of(foreign);
  CHECK(error_text([&] { SqliteBag<> map(foreign); }) ==
        foreign + ": it is a data base, but no map of topobag");
  CHECK(content_of(foreign) == before);
  CHECK(error_text([&] { SqliteBag<> map(folder.path("none.db"), read_only()); }) ==
        folder.path("none.db") + ": unable to open database file");
  const std::string empty = folder.write("empty.db", "");
  CHECK(error_text([&] { SqliteBag<> map(empty, read_only()); }) ==
        empty + ": it is a data base, but no map of topobag");

  const std::string later = folder.path("later.db");
  { SqliteBag<> map(later); }
  detail::SqliteConnection(later, false).run("PRAGMA user_version = 2");
  CHECK(error_text([&] { SqliteBag<> map(later); }) ==
        later + ": it is a map of a later version of topobag (schema 2): update topobag");
}

TEST_CASE("a map made with other classes is refused", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  SqliteOptions coco, paper;
  coco.catalog = ClassCatalog::coco80();
  paper.catalog = ClassCatalog::paper();
  { SqliteBag<> map(path, coco); }
  { SqliteBag<> map(path, coco); }
  { SqliteBag<> map(path); }
  CHECK(error_text([&] { SqliteBag<> map(path, paper); }) ==
        path +
            ": its class numbers mean other names than yours; open it with the catalog that it was "
            "made with");
}

TEST_CASE("a graph damaged within the file is named", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(6);
  const std::string path = folder.path("map.db");
  {
    SqliteBag<> map(path);
    map.add(KeyframeId{3}, random_graph(random, 5));
    map.add(KeyframeId{4}, random_graph(random, 5));
  }
  detail::SqliteConnection(path, false)
      .run("UPDATE keyframe SET graph = zeroblob(length(graph)) WHERE id = 4");
  CHECK(error_text([&] { SqliteBag<> map(path); }) ==
        path + ": key frame 4 cannot be read: its checksum does not fit: it is damaged");
}

TEST_CASE("a second writer is told to open the map again", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(7);
  const std::string path = folder.path("map.db");
  SqliteBag<> first(path);
  first.add(KeyframeId{1}, random_graph(random, 5));
  SqliteBag<> second(path);
  const SqliteBag<> reader(path, read_only());
  second.add(KeyframeId{2}, random_graph(random, 5));
  CHECK(error_text([&] { first.add(KeyframeId{3}, random_graph(random, 5)); }) ==
        path + ": another process has changed the map; open it again");
  CHECK(first.bag().size() == 1);
  CHECK(reader.bag().size() == 1);
  second.add(KeyframeId{4}, random_graph(random, 5));
  CHECK(SqliteBag<>(path, read_only()).bag().size() == 3);
}

TEST_CASE("what a map refuses changes nothing", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(8);
  const std::string path = folder.path("map.db");
  {
    SqliteBag<> map(path);
    map.add(KeyframeId{1}, random_graph(random, 5));
    const std::string before = saved(map.bag());
    EntryInfo bad;
    bad.stamp = std::nan("");
    CHECK_THROWS_AS(map.add(KeyframeId{2}, {}, bad), InvalidValue);
    CHECK_THROWS_AS(map.update(KeyframeId{1}, {}, bad), InvalidValue);
    std::vector<SemanticNode<>> far(1);
    far[0].position = Eigen::Vector3d(1e9, 0, 0);
    CHECK_THROWS_AS(map.add(KeyframeId{2}, TopologyGraph<>(far)), InvalidValue);
    CHECK(error_text([&] { map.add(KeyframeId{1}, {}); }) ==
          path + ": key frame 1 is in the map already: use update");
    CHECK(saved(map.bag()) == before);
  }
  CHECK(SqliteBag<>(path).bag().size() == 1);
}

TEST_CASE("a full disk is an error and loses nothing of a map", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(9);
  const std::string path = folder.path("map.db");
  { SqliteBag<>(path).add(KeyframeId{0}, random_graph(random, 12)); }
  const std::string said = text_from_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const ::rlimit size{60000, 60000};
    ::setrlimit(RLIMIT_FSIZE, &size);
    SqliteBag<> map(path);
    std::uint64_t id = 1;
    const std::string error = error_text([&] {
      for (;; ++id) map.add(KeyframeId{id}, random_graph(random, 12));
    });
    return std::to_string(map.bag().size() == id ? id : 0) + ' ' + error;
  });
  const std::size_t kept = std::stoul(said);
  CHECK(kept > 1);
  CHECK(said.substr(said.find(' ') + 1).find(path + ": ") == 0);
  CHECK(SqliteBag<>(path).bag().size() == kept);
}

TEST_CASE("a map in a folder that cannot be written to is read, not written", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(10);
  const std::string path = folder.path("map.db");
  { SqliteBag<>(path).add(KeyframeId{5}, random_graph(random, 12)); }
  REQUIRE(::chmod(folder.path().c_str(), 0555) == 0);
  const auto as_nobody = [&](const auto& call) {
    return text_from_child([&] {
      // Root may write anywhere: be nobody.
      if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) return std::string{};
      return std::string(call());
    });
  };
  const std::string read = as_nobody(
      [&] { return std::to_string(SqliteBag<>(path, read_only()).bag().size()) + " read"; });
  const std::string written = as_nobody([&] { return error_text([&] { SqliteBag<> map(path); }); });
  REQUIRE(::chmod(folder.path().c_str(), 0755) == 0);
  CHECK(read == "1 read");
  CHECK(written == path + ": attempt to write a readonly database");
  CHECK(SqliteBag<>(path).bag().size() == 1);
}

namespace {

/// Kills a process that adds key frames, at any moment; those it has told to be added must be
/// there, and at most the one that it was adding then.
void kill_adds(unsigned kills) {
  std::mt19937 random(11);
  std::vector<TopologyGraph<>> graphs;
  for (int i = 0; i < 50; ++i) graphs.push_back(random_graph(random, 10));
  std::optional<ScratchFolder> folder;
  std::uint64_t next = 0;
  std::uint64_t added = 0;
  for (unsigned round = 0; round < kills; ++round) {
    if (round % 20 == 0) {  // so that some are killed while they make the file
      folder.emplace();
      next = 0;
    }
    const std::string path = folder->path("map.db");
    ChildProcess child([&](const auto& tell) {
      SqliteBag<> map(path);
      for (std::uint64_t id = next;; ++id) {
        map.add(KeyframeId{id}, graphs[id % graphs.size()]);
        tell(id);
      }
    });
    std::uint64_t told = next;
    if (round % 2 == 0) told = child.told().value() + 1;  // however slow the machine, some get on
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 40000));
    child.kill();
    while (const auto id = child.told()) told = *id + 1;
    {
      const SqliteBag<> map(path);
      const std::uint64_t found = map.bag().size();
      REQUIRE((found == told || found == told + 1));
      map.bag().for_each([&](KeyframeId id, const auto&, const TopologyGraph<>& graph) {
        REQUIRE(value(id) < found);
        REQUIRE(encode(graph) == encode(graphs[value(id) % graphs.size()]));
      });
      added += found - next;
      next = found;
    }
    REQUIRE(ask(path, "PRAGMA integrity_check") == "ok");
  }
  CHECK(added >= kills / 2);
}

}  // namespace

TEST_CASE("a killed mapping run loses at most the key frame being written", "[sqlite]") {
  kill_adds(20);
}

TEST_CASE("300 killed mapping runs lose at most the key frame being written", "[sqlite][long]") {
  kill_adds(long_rounds(300));
}
