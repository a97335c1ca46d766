// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/matching/match_nodes.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

/// All sets of one-to-one pairs that agree, one query node after the other: the reference.
class ExhaustiveSearch {
 public:
  ExhaustiveSearch(const TopologyGraph<>& candidate, const TopologyGraph<>& query,
                   const ConsistencyOptions& options)
      : candidate_(candidate), query_(query), options_(options) {
    choose(0);
  }

  std::size_t size() const { return size_; }
  double rms_difference() const { return rms_; }

  bool agree(const Correspondence& a, const Correspondence& b) const {
    if (a.query == b.query || a.candidate == b.candidate) return false;
    const double difference =
        std::abs(length(candidate_, a.candidate, b.candidate) - length(query_, a.query, b.query));
    if (difference <= options_.min_tolerance) return true;
    const double deviation = std::sqrt(variance(candidate_, a.candidate, b.candidate) +
                                       variance(query_, a.query, b.query));
    return difference <= std::min(options_.max_tolerance, options_.deviations * deviation);
  }

  bool may_pair(const Correspondence& pair) const {
    const auto& p = candidate_.node(pair.candidate);
    const auto& q = query_.node(pair.query);
    const double ratio = p.size.norm() / q.size.norm();
    return p.position && q.position && p.label == q.label && ratio <= options_.max_size_ratio &&
           1.0 / ratio <= options_.max_size_ratio;
  }

  double rms_of(const std::vector<Correspondence>& pairs) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double difference = length(candidate_, pairs[i].candidate, pairs[j].candidate) -
                                  length(query_, pairs[i].query, pairs[j].query);
        sum += difference * difference;
        ++count;
      }
    }
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
  }

 private:
  static double length(const TopologyGraph<>& graph, NodeIndex i, NodeIndex j) {
    return (*graph.node(i).position - *graph.node(j).position).norm();
  }

  static double variance(const TopologyGraph<>& graph, NodeIndex i, NodeIndex j) {
    const Eigen::Vector3d u = (*graph.node(i).position - *graph.node(j).position).normalized();
    return u.dot(graph.node(i).covariance * u) + u.dot(graph.node(j).covariance * u);
  }

  void choose(std::size_t q) {
    if (chosen_.size() + (query_.size() - q) < size_) return;
    if (q == query_.size()) {
      const double rms = rms_of(chosen_);
      if (chosen_.size() > size_ || rms < rms_) rms_ = rms;
      size_ = std::max(size_, chosen_.size());
      return;
    }
    choose(q + 1);
    for (std::size_t p = 0; p < candidate_.size(); ++p) {
      const Correspondence pair{node_index(p), node_index(q)};
      if (!may_pair(pair)) continue;
      if (!std::all_of(chosen_.begin(), chosen_.end(),
                       [&](const Correspondence& other) { return agree(pair, other); })) {
        continue;
      }
      chosen_.push_back(pair);
      choose(q + 1);
      chosen_.pop_back();
    }
  }

  const TopologyGraph<>& candidate_;
  const TopologyGraph<>& query_;
  const ConsistencyOptions& options_;
  std::vector<Correspondence> chosen_;
  std::size_t size_ = 0;
  double rms_ = 0.0;
};

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
