// SPDX-License-Identifier: MIT
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>

#include "adaptors/sqlite_maps.hpp"
#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "child_process.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

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
