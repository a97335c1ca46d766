// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/matching/match_nodes.hpp>

#include "catch.hpp"
#include "matching/exhaustive_search.hpp"
#include "matching/layouts.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

struct Case {
  TopologyGraph<> candidate;
  TopologyGraph<> query;
};

/// In turn: two unrelated graphs, a noisy copy of a part, and two grids of one class.
Case any_case(std::mt19937& random, std::size_t round) {
  const std::size_t n = 1 + random() % 8, m = 1 + random() % 8;
  if (round % 3 == 0) return {noisy_graph(random, n, 3), noisy_graph(random, m, 3)};
  if (round % 3 == 1) {
    const TopologyGraph<> whole = noisy_graph(random, n, 2);
    return {whole, jittered(random, permuted(whole, random_order(random, n)), 1.0)};
  }
  const std::size_t columns = 1 + random() % 4;
  return {grid_graph(n, columns, 0.5), grid_graph(m, columns, 0.5)};
}

}  // namespace

TEST_CASE("coincident nodes are matched as exhaustive search matches them", "[matching]") {
  std::mt19937 random(63);
  const auto crowded = [&] {
    std::vector<SemanticNode<>> nodes(random() % 7);
    for (auto& node : nodes) {
      node.position = 0.0973 * Eigen::Vector3d(static_cast<double>(random() % 3), 0.0, 20.0);
      node.size = {0.2, 0.2};
      node.covariance = 1e-3 * static_cast<double>(1 + random() % 9) * Eigen::Matrix3d::Identity();
    }
    return TopologyGraph<>(nodes);
  };
  for (int round = 0; round < 500; ++round) {
    const TopologyGraph<> candidate = crowded(), query = crowded();
    const MatchNodesOptions options;
    const ExhaustiveSearch reference(candidate, query, options.consistency);
    const NodeMatching found = match_nodes(candidate, query, options);
    REQUIRE(found.pairs.size() == reference.size());
    REQUIRE(found.rms_difference == Approx(reference.rms_difference()).margin(1e-9));
  }
}

TEST_CASE("matching equals exhaustive search and ignores order and motion", "[matching]") {
  std::mt19937 random(71);
  const MatchNodesOptions options;
  std::size_t large = 0;
  for (std::size_t round = 0; round < 10000; ++round) {
    const Case c = any_case(random, round);
    const NodeMatching found = match_nodes(c.candidate, c.query, options);
    const ExhaustiveSearch truth(c.candidate, c.query, options.consistency);
    INFO("round " << round << ", " << c.candidate.size() << " x " << c.query.size());
    REQUIRE(found.complete);
    REQUIRE(found.pairs.size() == truth.size());
    REQUIRE(found.rms_difference == Approx(truth.rms_difference()).margin(1e-12));
    REQUIRE(found.rms_difference == Approx(truth.rms_of(found.pairs)).margin(1e-12));
    if (found.pairs.size() >= 4) ++large;

    const TopologyGraph<> candidate =
        moved(permuted(c.candidate, random_order(random, c.candidate.size())),
              random_motion(random, 5.0));
    const TopologyGraph<> query =
        moved(permuted(c.query, random_order(random, c.query.size())), random_motion(random, 5.0));
    const NodeMatching again = match_nodes(candidate, query, options);
    REQUIRE(again.pairs.size() == found.pairs.size());
    REQUIRE(again.rms_difference == Approx(found.rms_difference).margin(1e-9));
  }
  CHECK(large > 2000);  // the cases are not all trivial
}

TEST_CASE("a permutation carries the pairs along where the best is unique", "[matching]") {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    const TopologyGraph<> candidate = noisy_graph(random, 10, 3);
    const TopologyGraph<> query = jittered(random, candidate, 0.2);
    const auto order = random_order(random, query.size());
    const NodeMatching found = match_nodes(candidate, query);
    NodeMatching again = match_nodes(candidate, permuted(query, order));
    REQUIRE(found.pairs.size() == 10);
    for (Correspondence& pair : again.pairs) {
      const auto at = std::find(order.begin(), order.end(), value(pair.query));
      pair.query = node_index(static_cast<std::size_t>(at - order.begin()));
    }
    std::sort(again.pairs.begin(), again.pairs.end());
    CHECK(again.pairs == found.pairs);
  }
}

TEST_CASE("a search that ends with its budget says so and stays consistent", "[matching]") {
  const TopologyGraph<> candidate = grid_graph(16, 4, 0.5), query = grid_graph(16, 4, 0.5);
  const ConsistencyOptions consistency;
  const ConsistencyGraph graph(candidate, query, consistency);
  for (const std::size_t budget : {0U, 1U, 2U, 20U, 50U}) {
    MatchNodesOptions options;
    options.max_steps = budget;
    const NodeMatching found = match_nodes(candidate, query, options);
    CHECK_FALSE(found.complete);
    CHECK(found.steps == budget);
    std::vector<std::size_t> vertices;
    for (const Correspondence& pair : found.pairs) {
      const auto at = std::find(graph.pairs().begin(), graph.pairs().end(), pair);
      vertices.push_back(static_cast<std::size_t>(at - graph.pairs().begin()));
    }
    for (const std::size_t i : vertices) {
      for (const std::size_t j : vertices) CHECK((i == j || graph.agreement().test(i, j)));
    }
    const NodeMatching again = match_nodes(candidate, query, options);
    CHECK(again.pairs == found.pairs);
    CHECK(again.rms_difference == found.rms_difference);
  }
}

TEST_CASE("a budget just large enough changes nothing", "[matching]") {
  std::mt19937 random(9);
  const TopologyGraph<> candidate = noisy_graph(random, 8, 2);
  const TopologyGraph<> query = noisy_graph(random, 8, 2);
  const NodeMatching found = match_nodes(candidate, query);
  MatchNodesOptions options;
  options.max_steps = found.steps + 1;
  const NodeMatching again = match_nodes(candidate, query, options);
  CHECK(again.complete);
  CHECK(again.pairs == found.pairs);
}

TEST_CASE("a lone pair counts whatever its query node's index", "[matching][regression]") {
  const TopologyGraph<> candidate({object_at(7, {0, 0, 3})});
  for (std::size_t place = 0; place < 4; ++place) {
    std::vector<SemanticNode<>> nodes(4, object_at(1, {1, 0, 3}));
    nodes[place].label = ClassId{7};
    CHECK(match_nodes(candidate, TopologyGraph<>(nodes)).pairs ==
          std::vector<Correspondence>{{node_index(0), node_index(place)}});
  }
}

TEST_CASE("nothing to match is an empty matching", "[matching]") {
  std::mt19937 random(1);
  const TopologyGraph<> empty, some = noisy_graph(random, 5, 1);
  for (const NodeMatching& found :
       {match_nodes(empty, empty), match_nodes(empty, some), match_nodes(some, empty)}) {
    CHECK(found.pairs.empty());
    CHECK(found.rms_difference == 0.0);
    CHECK(found.complete);
  }
  const TopologyGraph<> unplaced(std::vector<SemanticNode<>>(4));
  CHECK(match_nodes(unplaced, unplaced).pairs.empty());
}

TEST_CASE("distances alone cannot tell a layout from its mirror image", "[matching]") {
  std::mt19937 random(2);
  const TopologyGraph<> graph = noisy_graph(random, 6, 6);
  CHECK(match_nodes(graph, mirrored(graph)).pairs.size() == match_nodes(graph, graph).pairs.size());
}
