// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>

#include "adaptors/sqlite_maps.hpp"
#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_appearance.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

TEST_CASE("files that are no map of ours are refused and stay as they are", "[sqlite]") {
  const ScratchFolder folder;
  const std::string text = folder.write("text.db", std::string(5000, 'x'));
  CHECK(error_text([&] { SqliteBag<> map(text); }) ==
        text +
            ": file is not a database: it is no SQLite map (a snapshot is for `load`), or damaged; "
            "take another copy");
  const std::string foreign = folder.path("foreign.db");
  detail::SqliteConnection(foreign, false).run("CREATE TABLE photos(id)");
  const std::string before = content_of(foreign);
  CHECK(error_text([&] { SqliteBag<> map(foreign); }) ==
        foreign + ": it is a data base, but no map of topobag");
  CHECK(content_of(foreign) == before);
  CHECK(error_text([&] { SqliteBag<> map(folder.path("none.db"), read_only()); }) ==
        folder.path("none.db") + ": unable to open database file: No such file or directory");
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

TEST_CASE("a graph of a later version within the file is named", "[sqlite][gravity]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  {
    SqliteBag<> map(path);
    map.add(KeyframeId{3}, TopologyGraph<>{});
  }
  const std::uint8_t later[] = {0x03, 0x04};
  detail::SqliteConnection(path, false)
      .run(("UPDATE keyframe SET graph = x'0304', checksum = " +
            std::to_string(detail::crc32(later, 2)))
               .c_str());
  CHECK(error_text([&] {
          SqliteBag<> map(path);
        }).find(path + ": key frame 3 cannot be read: a graph of format 3; this version") == 0);
}

TEST_CASE("a name that is no file is refused, as nothing would be kept", "[sqlite]") {
  for (const std::string name : {"", ":memory:"}) {
    CHECK(error_text([&] { SqliteBag<> map(name); }) ==
          "'" + name + "' is no file: a map there would be gone at the end; name one");
  }
}

TEST_CASE("numbers edited by hand are read as they are or refused, never as 0", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  EntryInfo posed;
  posed.stamp = 2.5;
  posed.T_world_camera = Eigen::Isometry3d::Identity();
  { SqliteBag<>(path).add(KeyframeId{3}, {}, posed); }
  const std::string whole = content_of(path);
  const auto edited = [&](const std::string& change) {
    folder.write("map.db", whole);
    detail::SqliteConnection(path, false).run(("UPDATE keyframe SET " + change).c_str());
    return error_text([&] { SqliteBag<> map(path, read_only()); });
  };
  const std::string begin = path + ": key frame 3 cannot be read: ";
  CHECK(edited("stamp = 7") == "nothing was thrown");
  CHECK(edited("stamp = 'noon'") == begin + "its 'stamp' is 'noon', which is no number");
  CHECK(edited("stamp = 1.3e18").find(begin + "the time stamp") == 0);
  CHECK(edited("qw = 2").find(begin + "the quaternion") == 0);
  CHECK(edited("ty = NULL") == begin + "its pose is not whole: tx to qw are seven numbers");
  CHECK(edited("session = -1") == begin + "its session is no whole number of 32 bits");
  CHECK(edited("session = 4294967296") == begin + "its session is no whole number of 32 bits");
}

TEST_CASE("sessions are numbered up to the last one and named in UTF-8", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  SqliteBag<> map(path);
  CHECK(error_text([&] {
          map.begin_session(
              "K\xFC"
              "che");
        }) == "the session's name is not UTF-8");
  EntryInfo last;
  last.session = 0xFFFFFFFFU;
  map.add(KeyframeId{1}, {}, last);
  CHECK(error_text([&] { map.begin_session("Monday"); }) ==
        "the numbers of sessions are used up: there are 2^32");
  CHECK(map.sessions().empty());
}

TEST_CASE("a session is added whole or not at all", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(11);
  const std::string path = folder.path("map.db");
  BagOfTopologyGraphs<> run;
  for (std::uint64_t id = 0; id < 5; ++id) run.add(KeyframeId{id}, random_graph(random, 5));
  {
    SqliteBag<> map(path);
    map.add(KeyframeId{3}, {});
    CHECK_THROWS_AS(map.add_session("Monday", run), InvalidId);
    CHECK(map.sessions().empty());
    CHECK(map.bag().size() == 1);
    map.erase(KeyframeId{3});
    CHECK(map.add_session("Tuesday", run) == 0);
    CHECK(map.begin_session("Wednesday") == 1);
    CHECK(map.bag().size() == 5);
  }
  const SqliteBag<> map(path, read_only());
  CHECK(map.bag().info(KeyframeId{4})->session == 0);
  REQUIRE(map.sessions().size() == 2);
  CHECK(map.sessions()[0].name == "Tuesday");
}

TEST_CASE("descriptors of another kind are refused before the file holds them",
          "[sqlite][appearance]") {
  const ScratchFolder folder;
  std::mt19937 random(1);
  const std::string path = folder.path("map.db");
  const TopologyGraph<> plain(random_nodes(random, 4, 3));
  const TopologyGraph<> one = with_appearance(random, plain, AppearanceKind("one", 8));
  const TopologyGraph<> other = with_appearance(random, plain, AppearanceKind("other", 8));
  const auto refuses = [](const auto& call) {
    return error_text(call).find("the key frame has descriptors of another kind") == 0;
  };
  for (const bool opened_again : {false, true}) {
    SqliteBag<> map(path);
    if (!opened_again) {
      map.add(KeyframeId{1}, plain);
      map.add(KeyframeId{2}, one);
    }
    CHECK(map.bag().appearance_kind() == one.appearance_kind());
    CHECK(refuses([&] { map.add(KeyframeId{3}, other); }));
    CHECK(refuses([&] { map.update(KeyframeId{1}, other); }));
    BagOfTopologyGraphs<> run;
    run.add(KeyframeId{4}, other);
    CHECK(refuses([&] { map.add_session("Tuesday", run); }));
    CHECK(map.bag().size() == 2);
    CHECK(map.sessions().empty());
  }
  CHECK(ask(path, "SELECT count(*) FROM keyframe") == "2");
}

namespace {

/// A similarity of the user's that cannot describe graphs of five nodes.
struct FussySimilarity {
  double descriptor(const TopologyGraph<>& graph) const {
    if (graph.size() == 5) throw InvalidValue("five nodes are too many");
    return static_cast<double>(graph.size());
  }
  double similarity(double a, double b) const { return a == b ? 1.0 : 0.0; }
  double operator()(const TopologyGraph<>& a, const TopologyGraph<>& b) const {
    return similarity(descriptor(a), descriptor(b));
  }
};

TopologyGraph<> graph_of_nodes(std::size_t count) {
  return TopologyGraph<>(std::vector<SemanticNode<>>(count));
}

}  // namespace

TEST_CASE("what a similarity cannot describe is not in the file either", "[sqlite][regression]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  using Bag = BagOfTopologyGraphs<TopologyGraph<>, FussySimilarity>;
  {
    SqliteBag<Bag> map(path);
    map.add(KeyframeId{1}, graph_of_nodes(4));
    CHECK_THROWS_AS(map.add(KeyframeId{2}, graph_of_nodes(5)), InvalidValue);
    CHECK_THROWS_AS(map.update(KeyframeId{1}, graph_of_nodes(5)), InvalidValue);
    BagOfTopologyGraphs<> run;
    run.add(KeyframeId{3}, graph_of_nodes(3));
    run.add(KeyframeId{4}, graph_of_nodes(5));
    CHECK_THROWS_AS(map.add_session("Monday", run), InvalidValue);
    CHECK(map.bag().size() == 1);
    CHECK(map.bag().find(KeyframeId{1})->size() == 4);
    CHECK(map.bag().query(graph_of_nodes(4)).size() == 1);
    CHECK(map.sessions().empty());
    map.add(KeyframeId{2}, graph_of_nodes(2));  // the map goes on
  }
  const SqliteBag<Bag> again(path);
  CHECK(again.bag().size() == 2);
  CHECK(again.bag().find(KeyframeId{1})->size() == 4);
}

TEST_CASE("a catalog says nothing of key frames that were written without one",
          "[sqlite][regression]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db"), named = folder.path("named.db");
  SqliteOptions coco;
  coco.catalog = ClassCatalog::coco80();
  SqliteBag<>(path).add(KeyframeId{1}, graph_of_nodes(4));
  CHECK(error_text([&] { SqliteBag<> map(path, coco); }) ==
        path +
            ": it holds key frames of which it is not said what their class numbers mean; open it "
            "without a catalog, or add them to a new map that has one");
  CHECK(ask(path, "SELECT count(*) FROM meta WHERE key = 'catalog'") == "0");
  const SqliteBag<> old(path);
  SqliteBag<> map(named, coco);
  map.add_session("old", old.bag());
  CHECK(map.bag().size() == 1);
}
