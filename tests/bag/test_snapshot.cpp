// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <sstream>
#include <string>

#include <topobag/bag/snapshot.hpp>

#include "bag/saved_bags.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

using Bag = BagOfTopologyGraphs<>;

}  // namespace

TEST_CASE("a bag comes back from a stream as it was", "[bag][snapshot]") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const Bag bag = random_bag(random, random() % 20);
    const std::string bytes = saved(bag);
    const Bag back = loaded(bytes);
    CHECK(saved(back) == bytes);
    REQUIRE(back.size() == bag.size());
    bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
      REQUIRE(back.contains(id));
      CHECK(back.info(id)->session == info.session);
      CHECK(back.info(id)->stamp == info.stamp);
      CHECK(back.info(id)->label == info.label);
      REQUIRE(back.info(id)->T_world_camera.has_value() == info.T_world_camera.has_value());
      if (info.T_world_camera) {
        CHECK(back.info(id)->T_world_camera->matrix() == info.T_world_camera->matrix());
      }
      CHECK(encode(*back.find(id)) == encode(graph));
    });
  }
}

TEST_CASE("a loaded bag answers as a bag of the decoded graphs does", "[bag][snapshot]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    Bag bag = random_bag(random, 40);
    Bag rounded;
    for (int step = 0; step < 100; ++step) {
      bag.erase(KeyframeId{random() % 100 * 1000003u});
      const KeyframeId id{random() % 100};
      const auto graph = random_graph(random, random() % 8, 80, false);
      bag.contains(id) ? bag.update(id, graph) : bag.add(id, graph);
    }
    bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
      rounded.add(id, decode(encode(graph)), info);
    });
    const Bag back = loaded(saved(bag));
    for (int i = 0; i < 50; ++i) {
      const auto query = random_graph(random, 6, 80, false);
      CHECK(back.query(query) == rounded.query(query));
    }
  }
}

TEST_CASE("bags of another scalar and with another similarity come back, too", "[bag][snapshot]") {
  struct SameSize {
    double size = 0.5;
    double operator()(const TopologyGraph<float>& a, const TopologyGraph<float>& b) const {
      return a.size() == b.size() ? size : 0.0;
    }
  };
  std::mt19937 random(3);
  const std::string bytes = saved(random_bag(random, 5));
  std::istringstream stream(bytes);
  using Other = BagOfTopologyGraphs<TopologyGraph<float>, SameSize>;
  const Other other = load<Other>(stream, 0, Other(SameSize{0.25}));
  REQUIRE(other.size() == 5);
  const auto graph = *other.find(KeyframeId{0});
  CHECK(other.query(graph).at(0).similarity == 0.25);
  std::istringstream again(saved(other));
  CHECK(inspect(again).scalar_bytes == 4);
}

TEST_CASE("views are left out on request", "[bag][snapshot]") {
  std::mt19937 random(4);
  const Bag bag = random_bag(random, 20);
  SaveOptions options;
  options.views = ViewSection::left_out;
  CHECK(saved(bag, options).size() < saved(bag).size());
  loaded(saved(bag, options)).for_each([](KeyframeId, const EntryInfo&, const auto& graph) {
    CHECK(graph.views().empty());
  });
}

TEST_CASE("several bags share a stream", "[bag][snapshot]") {
  std::mt19937 random(9);
  const Bag first = random_bag(random, 3), second = random_bag(random, 5);
  std::istringstream stream(saved(first) + saved(second));
  CHECK(saved(load<Bag>(stream)) == saved(first));
  CHECK(saved(load<Bag>(stream)) == saved(second));
}

TEST_CASE("a stream that fails is an error", "[bag][snapshot]") {
  std::mt19937 random(10);
  std::ostringstream stream;
  stream.setstate(std::ios::badbit);
  CHECK_THROWS_AS(save(random_bag(random, 1), stream), Error);
}
