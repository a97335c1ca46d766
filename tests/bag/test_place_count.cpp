// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/bag/place_count.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

EntryInfo at(double x, double y, double z, std::uint32_t session = 0) {
  EntryInfo info;
  info.session = session;
  info.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
  return info;
}

TopologyGraph<> one_object() {
  SemanticNode<> node;
  node.position = Eigen::Vector3d(0.1, 0.2, 2.0);
  return TopologyGraph<>({node});
}

}  // namespace

TEST_CASE("key frames of one spot are one place", "[bag]") {
  PlaceCount places;
  for (std::uint64_t id = 0; id < 50; ++id)
    places.add(KeyframeId{id}, at(1.0, 1.5, 0.01 * static_cast<double>(id)));
  CHECK(places.size() == 1);
  places.add(KeyframeId{50}, at(4.0, 1.5, 0.0));
  CHECK(places.size() == 2);
}

TEST_CASE("without poses, what a session passed within some seconds is a place",
          "[bag][regression]") {
  // However many key frames a second there are, and whatever their numbers.
  for (const unsigned per_second : {1U, 5U, 30U}) {
    PlaceCount places;
    EntryInfo info;
    const auto add_session = [&] {
      const double seconds = 2 * PlaceCount::seconds_per_place;
      for (unsigned i = 0; i < seconds * per_second; ++i) {
        info.stamp = static_cast<double>(i) / per_second;
        places.add(KeyframeId{1000 * info.session + 7 * i}, info);
      }
    };
    add_session();
    CHECK(places.size() == 2);
    info.session = 1;
    add_session();
    CHECK(places.size() == 4);
  }
}

TEST_CASE("key frames of which nothing tells what they are near are places each", "[bag]") {
  PlaceCount places;
  for (std::uint64_t id = 0; id < 10; ++id) places.add(KeyframeId{id}, EntryInfo{});
  CHECK(places.size() == 10);
}

TEST_CASE(
    "places are counted as brute force does, through adding, moving and erasing, by both bags",
    "[bag]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> metres(-8.0, 8.0);
  BagOfTopologyGraphs<> bag;
  IndexedBag indexed;
  std::map<std::uint64_t, Eigen::Vector3d> truth;
  const auto counted = [&] {
    std::set<std::tuple<double, double, double>> cells;
    for (const auto& [id, p] : truth) {
      cells.emplace(std::floor(p.x() / 3.0), std::floor(p.y() / 3.0), std::floor(p.z() / 3.0));
    }
    return cells.size();
  };
  for (int step = 0; step < 600; ++step) {
    const std::uint64_t id = random() % 80;
    const double x = metres(random), y = metres(random), z = metres(random);
    const EntryInfo info = at(x, y, z);
    if (truth.count(id) == 0) {
      bag.add(KeyframeId{id}, one_object(), info);
      indexed.add(KeyframeId{id}, one_object(), info);
      truth[id] = {x, y, z};
    } else if (random() % 2 == 0) {
      bag.update(KeyframeId{id}, one_object(), info);
      indexed.update(KeyframeId{id}, one_object(), info);
      truth[id] = {x, y, z};
    } else {
      bag.erase(KeyframeId{id});
      indexed.erase(KeyframeId{id});
      truth.erase(id);
    }
    REQUIRE(bag.places() == counted());
    REQUIRE(indexed.places() == counted());
  }
  const IndexedBag copy = indexed;
  CHECK(copy.places() == counted());
  IndexedBag merged;
  merged.merge(*indexed.view());
  CHECK(merged.places() == counted());
  indexed.compact();
  CHECK(indexed.places() == counted());
  indexed.clear();
  bag.clear();
  CHECK(indexed.places() + bag.places() == 0);
}

TEST_CASE("poses beyond all measure are counted", "[bag]") {
  PlaceCount places;
  places.add(KeyframeId{0}, at(1e300, -1e300, 0.0));
  places.add(KeyframeId{1}, at(1e300, -1e300, 1.0));
  CHECK(places.size() == 1);
  places.remove(KeyframeId{1}, at(1e300, -1e300, 1.0));
  places.remove(KeyframeId{0}, at(1e300, -1e300, 0.0));
  CHECK(places.size() == 0);
}
