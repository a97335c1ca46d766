// SPDX-License-Identifier: MIT
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <topobag/bag/bag_concepts.hpp>
#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/bag_reader.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "bag/moved_poses.hpp"
#include "bag/reading_calls.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

/// A view without any call beyond those that every view has.
struct BareView {
  using Graph = TopologyGraph<>;
  std::size_t size() const { return 3; }
  bool contains(KeyframeId id) const { return value(id) < size(); }
  std::optional<Graph> find(KeyframeId) const { return std::nullopt; }
  std::optional<EntryInfo> info(KeyframeId) const { return std::nullopt; }
  std::vector<Candidate> query(const Graph&, const QueryOptions& options) const {
    return std::vector<Candidate>(options.max_results);
  }
};

struct BareBag : BagReader<BareBag, BareView> {
  const BareView* view() const { return &bare; }
  BareView bare;
};

}  // namespace

TEST_CASE("every bag in memory has every reading call", "[bag]") {
  CHECK(missing_calls_of<BagOfTopologyGraphs<>>() == "");
  CHECK(missing_calls_of<IndexedBag>() == "");
  CHECK(missing_calls_of<BagView>() == "");
}

TEST_CASE("a bag has the calls that its view has", "[bag]") {
  CHECK(missing_calls_of<BareBag>() ==
        "after before within places places_holding appearance_kind image_kind ");
  const BareBag bag;
  CHECK(bag.size() == 3);
  CHECK_FALSE(bag.empty());
  CHECK(bag.contains(KeyframeId{2}));
  CHECK_FALSE(bag.contains(KeyframeId{3}));
  CHECK(bag.query({}).size() == QueryOptions{}.max_results);
  STATIC_REQUIRE(is_searchable_bag_v<BareBag>);
  STATIC_REQUIRE_FALSE(is_stored_bag_v<BareBag>);
}

TEST_CASE("a bag answers as its view does, and a view keeps what it saw", "[bag][index]") {
  std::mt19937 random(17);
  IndexedBag bag;
  CHECK(bag.empty());
  CHECK(bag.within({Eigen::Vector3d::Zero(), 1e9}).empty());
  for (std::uint64_t i = 0; i < 700; ++i) {
    EntryInfo info;
    if (i % 3 != 0) info.T_world_camera = camera_in_flat(random);
    bag.add(KeyframeId{(i * 7919) % 2000}, random_graph(random, 5, 4, false), info);
  }
  const auto before = bag.view();
  const MapRegion everywhere{Eigen::Vector3d::Zero(), 1e9};
  const auto all = before->within(everywhere);
  CHECK(all.size() == 466);
  CameraPoses moved;
  for (const KeyframeId id : all) moved.emplace(id, camera_in_flat(random));
  for (int round = 0; round < 30; ++round) {
    const MapRegion region{camera_in_flat(random).translation(), 0.3 * round};
    check_within(*before, region);
    check_within(bag, region);
    const auto was = before->within(region);
    if (round == 10) bag.set_poses(moved);
    if (round == 15) bag.compact();
    if (round > 20) bag.erase(all[static_cast<std::size_t>(round)]);
    CHECK(before->within(region) == was);
    CHECK(bag.within(region) == bag.view()->within(region));
    CHECK(bag.memory_usage().total() == bag.view()->memory_usage().total());
  }
}
