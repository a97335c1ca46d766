// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "bag/desk_pieces.hpp"
#include "bag/filled_bags.hpp"
#include "bag/refusals.hpp"
#include "catch.hpp"
#include "long_rounds.hpp"
#include "recombined_graphs.hpp"

using namespace topobag;

namespace {

using Graph = TopologyGraph<>;

Graph stored(const Graph& graph) { return decode<double>(encode(graph)); }

QueryOptions random_options(RecombinedGraphs& source, std::uint64_t ids) {
  QueryOptions options;
  options.max_results = source.chance(0.7) ? 10 : source.below(40);
  if (source.chance(0.3)) options.min_similarity = source.unit();
  if (source.chance(0.6)) return options;
  const std::uint64_t id = source.below(ids);
  switch (source.below(6)) {
    case 0:
      options.exclude.id = KeyframeId{id};
      options.exclude.min_id_gap = 50;
      break;
    case 1:
      options.exclude.stamp = 0.4 * static_cast<double>(id);
      options.exclude.min_time_gap = 20.0;
      break;
    case 2:
      options.among.min_id = KeyframeId{id};
      options.among.max_stamp = 0.4 * static_cast<double>(id + 500);
      break;
    case 3:
      options.among.sessions = {1, 3};
      break;
    case 4:
      options.among.region = MapRegion{Eigen::Vector3d(0.1 * static_cast<double>(id), 0, 0), 20.0};
      break;
    default:
      options.filter = [](KeyframeId candidate, const EntryInfo& info) {
        return value(candidate) % 3 == 0 || info.label == "upstairs";
      };
  }
  return options;
}

EntryInfo random_info(RecombinedGraphs& source, std::uint64_t id) {
  EntryInfo info;
  if (!source.chance(0.1)) info.stamp = 0.4 * static_cast<double>(id);
  info.session = static_cast<std::uint32_t>(source.below(5));
  if (source.chance(0.2)) info.label = "upstairs";
  if (source.chance(0.5)) {
    info.T_world_camera = Eigen::Isometry3d::Identity();
    info.T_world_camera->translation().x() = 0.1 * static_cast<double>(id);
    info.T_world_camera->rotate(Eigen::AngleAxisd(source.unit(), Eigen::Vector3d::UnitY()));
  }
  return info;
}

/// The same sequence of random changes and queries through both bags.
void compare_with_brute_force(std::uint64_t seed, std::uint64_t ids, std::size_t steps,
                              std::size_t queries, bool in_order) {
  RecombinedGraphs source(desk_pieces(static_cast<unsigned>(seed)), seed);
  IndexedBag bag;
  BruteForceBag oracle;
  std::vector<RecombinedGraphs::Nodes> places{source.place()};
  Graph last = source.keyframe(places.back());
  std::uint64_t next = 0;
  std::size_t differences = 0;
  for (std::size_t step = 0; step < steps; ++step) {
    if (source.chance(0.06)) places.push_back(source.place());
    Graph graph = source.keyframe(in_order ? places.back() : places[source.below(places.size())]);
    if (source.chance(0.05)) graph = last;  // a tie
    last = graph;
    const KeyframeId id{in_order && next < ids ? next++ : source.below(ids)};
    const EntryInfo info = random_info(source, value(id));
    if (source.chance(0.25)) {
      differences += bag.erase(id) == oracle.erase(id) ? 0U : 1U;
    } else if (oracle.contains(id)) {
      bag.update(id, graph, info);
      oracle.update(id, stored(graph), info);
    } else {
      bag.add(id, graph, info);
      oracle.add(id, stored(graph), info);
    }
    if (source.chance(2.0 / static_cast<double>(steps))) bag.compact();
    if (source.chance(2.0 / static_cast<double>(steps))) bag = IndexedBag(bag);
    if (!source.chance(static_cast<double>(queries) / static_cast<double>(steps))) continue;
    const Graph query = source.keyframe(places[source.below(places.size())]);
    const QueryOptions options = random_options(source, ids);
    differences += bag.query(query, options) == oracle.query(query, options) ? 0U : 1U;
    const double x = 0.1 * static_cast<double>(source.below(ids));
    const MapRegion region{Eigen::Vector3d(x, 0, 0), source.chance(0.1) ? 1e9 : 30 * source.unit()};
    differences += bag.within(region) == oracle.within(region) ? 0U : 1U;
  }
  CHECK(differences == 0);
  REQUIRE(bag.size() == oracle.size());
  std::vector<KeyframeId> kept;
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const Graph& graph) {
    kept.push_back(id);
    const auto wanted = oracle.info(id);
    REQUIRE(wanted);
    CHECK(encode(graph) == encode(*oracle.find(id)));
    CHECK(info.stamp == wanted->stamp);
    CHECK(info.session == wanted->session);
    CHECK(info.label == wanted->label);
    REQUIRE(info.T_world_camera.has_value() == wanted->T_world_camera.has_value());
    if (info.T_world_camera) CHECK(info.T_world_camera->isApprox(*wanted->T_world_camera, 1e-14));
  });
  CHECK(std::is_sorted(kept.begin(), kept.end()));
  CHECK(kept.size() == bag.size());
}

}  // namespace

TEST_CASE("an indexed bag answers as brute force over its graphs does", "[bag][index]") {
  compare_with_brute_force(1, 50, 400, 200, false);
  compare_with_brute_force(2, 700, 1500, 250, true);
  compare_with_brute_force(3, 700, 1500, 250, false);
}

TEST_CASE("an indexed bag answers thousands of queries as brute force does", "[bag][index][long]") {
  for (std::uint64_t seed = 10; seed < 10 + long_rounds(5); ++seed) {
    compare_with_brute_force(seed, 100, 5000, 2500, false);
    compare_with_brute_force(seed, 5000, 9000, 1000, true);
    compare_with_brute_force(seed, 5000, 9000, 700, false);
  }
}

TEST_CASE("the index keeps to unusual graphs, weights and bins", "[bag][index]") {
  std::mt19937 random(5);
  std::vector<Graph> graphs{Graph{}};
  for (const std::size_t size : {1u, 2u, 5u, 20u, 60u}) {
    graphs.push_back(random_graph(random, size, 2));
    graphs.push_back(random_graph(random, size, 2, false));
    graphs.push_back(random_graph(random, size, 300));
    std::vector<Graph::Node> heap = random_nodes(random, size, 1);  // heavy words
    for (auto& node : heap) node.position = Eigen::Vector3d(1e-3 * node.size.x(), 0.0, 2.0);
    graphs.emplace_back(heap);
    for (auto& node : heap) node.label = ClassId{-7};
    heap.front().position = Eigen::Vector3d(900.0, -900.0, 1e5);
    heap.back().size = {200.0, 0.0};
    graphs.emplace_back(heap);
  }
  ClassPairDistanceHistogram weighted, coarse, without_sizes;
  weighted.weights.set(ClassId{1}, 30.0);
  weighted.weights.set(ClassId{2}, 0.0);
  weighted.weights.set(ClassId{3}, 1e-3);
  coarse.bin_width = 7.0;
  without_sizes.size_vote = 0.0;
  for (const auto& similarity : {ClassPairDistanceHistogram{}, weighted, coarse, without_sizes}) {
    IndexedBag bag(similarity);
    for (std::uint64_t i = 0; i < 400; ++i) bag.add(KeyframeId{i}, graphs[i % graphs.size()]);
    const BruteForceBag oracle = brute_force_of(bag, similarity);
    for (const Graph& query : graphs) {
      for (const std::size_t results : {1u, 10u, 500u}) {
        QueryOptions options;
        options.max_results = results;
        CHECK(bag.query(query, options) == oracle.query(query, options));
      }
    }
  }
}

TEST_CASE("ties of equal graphs, and of graphs with nothing in common, go by id", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(1), 1);
  const auto place = source.place();
  const Graph graph = source.keyframe(place);
  std::vector<Graph::Node> others = graph.nodes();
  for (auto& node : others) node.label = ClassId{value(node.label) + 100};
  IndexedBag bag;
  for (std::uint64_t i = 500; i-- > 0;)
    bag.add(KeyframeId{i}, i % 100 == 7 ? graph : Graph(others));
  QueryOptions options;
  options.max_results = 7;
  const auto found = bag.query(stored(graph), options);
  REQUIRE(found.size() == 7);
  const std::uint64_t wanted[] = {7, 107, 207, 307, 407, 0, 1};
  for (std::size_t i = 0; i < 7; ++i) {
    CHECK(value(found[i].id) == wanted[i]);
    CHECK(found[i].similarity == (i < 5 ? 1.0 : 0.0));
  }
  options.min_similarity = 1e-9;
  CHECK(bag.query(stored(graph), options).size() == 5);
  options.max_results = 0;
  CHECK(bag.query(graph, options).empty());
  CHECK(IndexedBag{}.query(graph).empty());
}

TEST_CASE("a least score beyond those there are is no trap", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(8), 8);
  IndexedBag bag = bag_of(source, 20);
  // Empty graphs beside slight ones: rounded up, these share more than both weigh.
  const Graph slight(std::vector<Graph::Node>(1));
  for (std::uint64_t i = 500; i < 800; ++i) bag.add(KeyframeId{i}, i % 2 == 0 ? slight : Graph{});
  const BruteForceBag oracle = brute_force_of(bag);
  using Limits = std::numeric_limits<double>;
  for (const double least : {-Limits::infinity(), Limits::lowest(), -1e300, -1.0, -0.0, 1.0, 1.5,
                             1e300, Limits::infinity(), Limits::quiet_NaN()}) {
    for (const std::size_t results : {1u, 10u, 1000u}) {
      QueryOptions options;
      options.min_similarity = least;
      options.max_results = results;
      const Graph query = source.keyframe(source.place());
      CHECK(bag.query(query, options) == oracle.query(query, options));
      CHECK(bag.query(slight, options) == oracle.query(slight, options));
    }
  }
}

TEST_CASE("what an indexed bag refuses changes nothing", "[bag][index]") {
  check_refusals<IndexedBag>();
}

TEST_CASE("an indexed bag may be changed while it is walked through", "[bag]") {
  check_walk_that_changes_the_bag<IndexedBag>();
}
