// SPDX-License-Identifier: MIT
#include <string>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/snapshot_file.hpp>
#include <topobag/bag/writer_lock.hpp>

#include "catch.hpp"
#include "child_process.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

TEST_CASE("two processes that add to one snapshot lose nothing", "[bag]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.bag");
  save(BagOfTopologyGraphs<>(), path);
  const auto add_range = [&](std::uint64_t first) {
    return [&path, first](const auto&) {
      for (std::uint64_t id = first; id < first + 20; ++id) {
        const WriterLock lock(path);
        auto bag = load<BagOfTopologyGraphs<>>(path);
        bag.add(KeyframeId{id}, TopologyGraph<>());
        save(bag, path);
      }
    };
  };
  ChildProcess one(add_range(0)), other(add_range(100));
  CHECK(one.wait());
  CHECK(other.wait());
  CHECK(load<BagOfTopologyGraphs<>>(path).size() == 40);
}

TEST_CASE("a lock leaves nothing behind and names what it cannot lock", "[bag]") {
  const ScratchFolder folder;
  { const WriterLock lock(folder.path("new.bag")); }
  CHECK(std::filesystem::is_empty(folder.path()));
  const std::string nowhere = folder.path("no/map.bag");
  CHECK(error_text([&] { WriterLock lock(nowhere); }) ==
        nowhere + " cannot be written: its folder cannot be locked: No such file or directory");
}
