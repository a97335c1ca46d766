// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/similarity/class_histogram.hpp>

#include "bag/refusals.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

using Graph = TopologyGraph<>;

/// A user's similarity, without a descriptor and with many ties.
struct SameSize {
  double operator()(const Graph& a, const Graph& b) const {
    return a.size() == b.size() ? 1.0 : 0.25;
  }
};

struct Model {
  Graph graph;
  EntryInfo info;
};

/// What a query has to return: scores by the similarity itself, a full sort.
template <typename Similarity>
std::vector<std::pair<double, std::uint64_t>> expected(const std::map<std::uint64_t, Model>& model,
                                                       const Graph& query,
                                                       const QueryOptions& options) {
  std::vector<std::pair<double, std::uint64_t>> found;
  for (const auto& [id, entry] : model) {
    const double score = Similarity{}(query, entry.graph);
    if (score < options.min_similarity) continue;
    if (options.exclude.contains(KeyframeId{id}, entry.info)) continue;
    if (options.filter && !options.filter(KeyframeId{id}, entry.info)) continue;
    found.emplace_back(-score, id);
  }
  std::sort(found.begin(), found.end());
  if (found.size() > options.max_results) found.resize(options.max_results);
  return found;
}

template <typename Similarity>
void check_query(const BagOfTopologyGraphs<Graph, Similarity>& bag,
                 const std::map<std::uint64_t, Model>& model, const Graph& query,
                 const QueryOptions& options) {
  std::vector<std::pair<double, std::uint64_t>> found;
  for (const Candidate& candidate : bag.query(query, options)) {
    found.emplace_back(-candidate.similarity, value(candidate.id));
  }
  CHECK(found == expected<Similarity>(model, query, options));
}

}  // namespace

TEMPLATE_TEST_CASE("a bag behaves like a map that is sorted for each query", "[bag]",
                   ClassPairDistanceHistogram, ClassHistogram, SameSize) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::uint64_t> id_of(0, 30);
    std::uniform_int_distribution<std::size_t> size(0, 8);
    std::uniform_int_distribution<int> action(0, 9);
    BagOfTopologyGraphs<Graph, TestType> bag;
    std::map<std::uint64_t, Model> model;
    for (int step = 0; step < 300; ++step) {
      const std::uint64_t id = id_of(random);
      const KeyframeId key{id};
      Graph graph = random_graph(random, size(random), 3, false);
      EntryInfo info;
      if (id % 3 != 0) info.stamp = static_cast<double>(id);
      info.session = static_cast<std::uint32_t>(step);
      const int what = action(random);
      if (what < 4) {
        if (model.count(id) != 0) {
          CHECK_THROWS_AS(bag.add(key, graph, info), InvalidId);
        } else {
          bag.add(key, graph, info);
          model[id] = {graph, info};
        }
      } else if (what < 6) {
        if (model.count(id) == 0) {
          CHECK_THROWS_AS(bag.update(key, graph, info), InvalidId);
        } else {
          bag.update(key, graph, info);
          model[id] = {graph, info};
        }
      } else if (what < 8) {
        CHECK(bag.erase(key) == (model.erase(id) == 1));
      } else {
        QueryOptions options;
        options.max_results = size(random);
        options.min_similarity = what == 8 ? 0.0 : 0.3;
        if (step % 2 == 0) options.exclude.id = key;
        options.exclude.min_id_gap = 4;
        if (step % 3 == 0) options.exclude.stamp = static_cast<double>(id);
        options.exclude.min_time_gap = 5.0;
        if (step % 5 == 0) {
          options.filter = [](KeyframeId candidate, const EntryInfo& entry) {
            return value(candidate) % 2 == 0 || entry.session < 100;
          };
        }
        check_query(bag, model, graph, options);
      }
      REQUIRE(bag.size() == model.size());
      CHECK(bag.empty() == model.empty());
      CHECK(bag.contains(key) == (model.count(id) == 1));
      CHECK(bag.info(key).has_value() == (model.count(id) == 1));
      REQUIRE((bag.peek(key) != nullptr) == (model.count(id) == 1));
      if (bag.peek(key)) CHECK(bag.peek(key)->size() == model[id].graph.size());
    }
    for (const auto& [id, entry] : model) {
      REQUIRE(bag.find(KeyframeId{id}));
      CHECK(bag.find(KeyframeId{id})->size() == entry.graph.size());
      CHECK(bag.find(KeyframeId{id})->edges() == entry.graph.edges());
      CHECK(bag.info(KeyframeId{id})->session == entry.info.session);
      CHECK(bag.info(KeyframeId{id})->stamp == entry.info.stamp);
    }
    bag.clear();
    CHECK(bag.empty());
    CHECK(bag.query(Graph{}).empty());
  }
}

TEST_CASE("the order of adding does not matter", "[bag]") {
  std::mt19937 random(1);
  std::vector<Graph> graphs;
  for (int i = 0; i < 20; ++i) graphs.push_back(random_graph(random, 5));
  BagOfTopologyGraphs<> forth, shuffled;
  for (std::size_t i = 0; i < 20; ++i) forth.add(KeyframeId{i}, graphs[i]);
  for (const std::size_t i : random_order(random, 20)) shuffled.add(KeyframeId{i}, graphs[i]);
  const Graph query = random_graph(random, 5);
  CHECK(forth.query(query) == shuffled.query(query));
}

TEST_CASE("a bag tells which cameras stand in a region, whatever was added and taken", "[bag]") {
  BagOfTopologyGraphs<> bag;
  const auto at = [](double x) {
    EntryInfo info;
    info.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, 0.0));
    return info;
  };
  for (const std::uint64_t id : {4u, 2u, 3u}) bag.add(KeyframeId{id}, Graph{}, at(0.5));
  bag.add(KeyframeId{5}, Graph{});
  bag.update(KeyframeId{3}, Graph{}, at(10.0));
  bag.erase(KeyframeId{4});
  const auto copy = bag;
  bag.clear();
  CHECK(bag.within({Eigen::Vector3d::Zero(), 1e3}).empty());
  CHECK(copy.within({Eigen::Vector3d::Zero(), 1.0}) == std::vector<KeyframeId>{KeyframeId{2}});
  CHECK(copy.within({Eigen::Vector3d::Zero(), 20.0}) ==
        std::vector<KeyframeId>{KeyframeId{2}, KeyframeId{3}});
}

TEST_CASE("ties are cut off by id", "[bag]") {
  BagOfTopologyGraphs<Graph, SameSize> bag;
  for (const std::uint64_t id : {8u, 3u, 5u, 1u}) bag.add(KeyframeId{id}, Graph{});
  QueryOptions two;
  two.max_results = 2;
  CHECK(bag.query(Graph{}, two) ==
        std::vector<Candidate>{{KeyframeId{1}, 1.0}, {KeyframeId{3}, 1.0}});
}

TEST_CASE("what is refused says why and changes nothing", "[bag]") {
  check_refusals<BagOfTopologyGraphs<>>();
}

TEST_CASE("a bag may be changed while it is walked through", "[bag]") {
  check_walk_that_changes_the_bag<BagOfTopologyGraphs<>>();
}
