// SPDX-License-Identifier: MIT
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <topobag/adaptors/sqlite.hpp>

#include "adaptors/sqlite_maps.hpp"
#include "catch.hpp"
#include "child_process.hpp"
#include "error_text.hpp"
#include "long_rounds.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

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

TEST_CASE("a killed mapping run loses at most the key frame being written", "[sqlite]") {
  kill_adds(20);
}

TEST_CASE("300 killed mapping runs lose at most the key frame being written", "[sqlite][long]") {
  kill_adds(long_rounds(300));
}

TEST_CASE("what a killed process had not finished is taken back, for reading too", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  std::mt19937 random(12);
  BagOfTopologyGraphs<> run;
  for (std::uint64_t id = 0; id < 200; ++id) run.add(KeyframeId{id}, random_graph(random, 12));
  SqliteBag<>(path).add_session("Monday", run);
  ChildProcess writer([&](const auto& tell) {
    const detail::SqliteConnection connection(path, false);
    // With so small a cache changed pages go to the file before the end.
    connection.run("PRAGMA cache_size = 1; BEGIN IMMEDIATE; UPDATE keyframe SET label = 'half'");
    tell(1);
    ::pause();
  });
  REQUIRE(writer.told() == 1U);
  writer.kill();
  REQUIRE(std::filesystem::file_size(path + "-journal") > 0);
  SqliteOptions reading;
  reading.read_only = true;
  const std::string half = content_of(path), before = content_of(path + "-journal");
  const std::string link = folder.path("link.db");
  std::filesystem::create_symlink(path, link);
  for (const std::string& name : {path, std::filesystem::relative(path).string(), link}) {
    CAPTURE(name);
    folder.write("map.db", half);
    folder.write("map.db-journal", before);
    CHECK(SqliteBag<>(name, reading).bag().info(KeyframeId{1})->label.empty());
    CHECK_FALSE(std::filesystem::exists(path + "-journal"));
  }
}
