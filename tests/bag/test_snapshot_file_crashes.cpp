// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <thread>

#include <topobag/bag/snapshot_file.hpp>

#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "child_process.hpp"
#include "long_rounds.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

using Bag = BagOfTopologyGraphs<>;

/// A bag that says how often it was saved before.
Bag numbered(Bag bag, std::uint64_t number) {
  EntryInfo info;
  info.stamp = static_cast<double>(number);
  bag.update(KeyframeId{0}, {}, info);
  return bag;
}
std::uint64_t number_of(const Bag& bag) {
  return static_cast<std::uint64_t>(*bag.info(KeyframeId{0})->stamp);
}

/// Kills a process that saves again and again, at any moment; what it has told to be saved must be
/// there, or what it was saving then.
void kill_saves(unsigned kills) {
  const ScratchFolder folder;
  std::mt19937 random(7);
  const std::string path = folder.path("room.bag");
  const Bag bag = random_bag(random, 200);
  save(numbered(bag, 0), path);
  std::uint64_t last = 0;
  std::size_t interrupted = 0;
  for (unsigned round = 0; round < kills; ++round) {
    ChildProcess child([&](const auto& tell) {
      for (std::uint64_t number = last + 1;; ++number) {
        save(numbered(bag, number), path);
        tell(number);
      }
    });
    std::uint64_t told = last;
    if (round % 2 == 0) told = child.told().value();  // however slow the machine, some get on
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 30000));
    child.kill();
    while (const auto number = child.told()) told = *number;
    const std::uint64_t found = number_of(load(path));
    REQUIRE((found == told || found == told + 1));
    REQUIRE(content_of(path) == saved(numbered(bag, found)));
    last = found;
    for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
      if (file.path() == path) continue;
      CHECK(file.path().filename().string().find("room.bag.part-") == 0);
      std::filesystem::remove(file.path());
      ++interrupted;
    }
  }
  CHECK(interrupted > 0);
  CHECK(last >= kills / 2);
}

}  // namespace

TEST_CASE("a save that is killed leaves a whole file", "[bag][snapshot]") { kill_saves(20); }

TEST_CASE("300 saves that are killed leave a whole file", "[bag][snapshot][long]") {
  kill_saves(long_rounds(300));
}
