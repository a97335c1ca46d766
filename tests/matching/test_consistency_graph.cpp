// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <topobag/matching/consistency_graph.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

/// Two objects of different classes, `metres` apart.
TopologyGraph<> two_apart(double metres, double deviation = 0.0) {
  std::vector<SemanticNode<>> nodes{object_at(1, {0, 0, 3}), object_at(2, {metres, 0, 3})};
  const double variance = deviation * deviation + 1e-12;
  for (auto& node : nodes) node.covariance = variance * Eigen::Matrix3d::Identity();
  return TopologyGraph<>(std::move(nodes));
}

bool lengths_agree(const TopologyGraph<>& candidate, const TopologyGraph<>& query,
                   const ConsistencyOptions& options = {}) {
  const ConsistencyGraph graph(candidate, query, options);
  REQUIRE(graph.pairs().size() == 2);
  return graph.agreement().test(0, 1);
}

}  // namespace

TEST_CASE("pairs are those of one class, sorted by query node", "[matching]") {
  std::mt19937 random(62);
  for (int round = 0; round < 100; ++round) {
    const TopologyGraph<> candidate = random_graph(random, 9, 3, false);
    const TopologyGraph<> query = random_graph(random, 8, 3, false);
    ConsistencyOptions options;
    options.max_size_ratio = 2.0;
    const ConsistencyGraph graph(candidate, query, options);
    std::vector<Correspondence> expected;
    for (std::size_t q = 0; q < query.size(); ++q) {
      for (std::size_t p = 0; p < candidate.size(); ++p) {
        const auto &a = candidate.nodes()[p], &b = query.nodes()[q];
        const double ratio = a.size.norm() / b.size.norm();
        if (a.label == b.label && a.position && b.position && ratio <= 2.0 && ratio >= 0.5) {
          expected.push_back({node_index(p), node_index(q)});
        }
      }
    }
    CHECK(graph.pairs() == expected);
    CHECK(graph.complete());
    REQUIRE(graph.query_of().size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CHECK(graph.query_of()[i] == value(expected[i].query));
      CHECK_FALSE(graph.agreement().test(i, i));
      for (std::size_t j = 0; j < expected.size(); ++j) {
        CHECK(graph.agreement().test(i, j) == graph.agreement().test(j, i));
        if (expected[i].query == expected[j].query ||
            expected[i].candidate == expected[j].candidate) {
          CHECK_FALSE(graph.agreement().test(i, j));
        }
      }
    }
  }
}

TEST_CASE("distances agree within the noise, between the two tolerances", "[matching]") {
  const TopologyGraph<> exact = two_apart(1.0), loose = two_apart(1.0, 0.04);
  CHECK(lengths_agree(exact, two_apart(1.049)));
  CHECK_FALSE(lengths_agree(exact, two_apart(1.051)));
  // Four positions of 0.04 m: 0.08 m, of which 2.5 are 0.2 m.
  CHECK(lengths_agree(loose, two_apart(1.199, 0.04)));
  CHECK_FALSE(lengths_agree(loose, two_apart(1.201, 0.04)));
  CHECK(lengths_agree(two_apart(1.0, 1.0), two_apart(1.399, 1.0)));
  CHECK_FALSE(lengths_agree(two_apart(1.0, 1.0), two_apart(1.401, 1.0)));
}

TEST_CASE("only the noise along the line between two nodes counts", "[matching]") {
  auto nodes = two_apart(1.0).nodes();
  for (auto& node : nodes) node.covariance = Eigen::Vector3d(1e-12, 1.0, 1.0).asDiagonal();
  CHECK_FALSE(lengths_agree(TopologyGraph<>(nodes), two_apart(1.1)));
  for (auto& node : nodes) node.covariance = Eigen::Vector3d(1.0, 1e-12, 1e-12).asDiagonal();
  CHECK(lengths_agree(TopologyGraph<>(nodes), two_apart(1.1)));
}

TEST_CASE("coincident nodes have a distance of zero, with noise", "[matching]") {
  CHECK(lengths_agree(two_apart(0.0, 0.04), two_apart(0.19, 0.04)));
  CHECK_FALSE(lengths_agree(two_apart(0.0, 0.04), two_apart(0.21, 0.04)));
}

TEST_CASE("a node whose covariance is not modelled has the default noise",
          "[matching][regression]") {
  auto nodes = two_apart(1.0).nodes();
  for (auto& node : nodes) node.covariance.setZero();
  auto given = nodes;
  for (auto& node : given) node.covariance = position_covariance(node);
  const TopologyGraph<> bare(nodes), modelled(given);
  for (double metres = 0.8; metres < 1.2; metres += 0.01) {
    CHECK(lengths_agree(bare, two_apart(metres)) == lengths_agree(modelled, two_apart(metres)));
  }
  CHECK(lengths_agree(bare, two_apart(1.06)));
}

TEST_CASE("classes of one group pair up", "[matching]") {
  const TopologyGraph<> tv({object_at(1, {0, 0, 3})}), laptop({object_at(2, {0, 0, 3})});
  ConsistencyOptions options;
  CHECK(ConsistencyGraph(tv, laptop, options).pairs().empty());
  options.classes.join(ClassId{1}, ClassId{2});
  CHECK(ConsistencyGraph(tv, laptop, options).pairs().size() == 1);
}

TEST_CASE("an unknown size pairs with any", "[matching]") {
  SemanticNode<> large = object_at(1, {0, 0, 3}), unknown = large;
  large.size = {5.0, 5.0};
  unknown.size.setZero();
  const TopologyGraph<> small({object_at(1, {0, 0, 3})});
  CHECK(ConsistencyGraph(TopologyGraph<>({large}), small, {}).pairs().empty());
  CHECK(ConsistencyGraph(TopologyGraph<>({unknown}), small, {}).pairs().size() == 1);
}

TEST_CASE("beyond max_pairs rare classes stay whole and common ones keep the most alike",
          "[matching][regression]") {
  std::vector<SemanticNode<>> nodes;
  for (int i = 0; i < 6; ++i) {
    nodes.push_back(object_at(i < 4 ? 1 : 2, {0.3 * i, 0, 3}));
    nodes.back().size *= 1.0 + 0.1 * i;
  }
  const TopologyGraph<> graph(nodes);  // 16 pairs of class 1, 4 of class 2
  ConsistencyOptions options;
  options.max_pairs = 20;
  CHECK(ConsistencyGraph(graph, graph, options).pairs().size() == 20);
  CHECK(ConsistencyGraph(graph, graph, options).complete());
  for (const std::size_t max_pairs : {18U, 8U, 4U}) {
    options.max_pairs = max_pairs;
    const ConsistencyGraph cut(graph, graph, options);
    CHECK_FALSE(cut.complete());
    CHECK(cut.pairs().size() == max_pairs);
    CHECK(std::is_sorted(cut.pairs().begin(), cut.pairs().end()));
    const auto of_rare = [&](const Correspondence& pair) {
      return graph.node(pair.query).label == ClassId{2};
    };
    CHECK(std::count_if(cut.pairs().begin(), cut.pairs().end(), of_rare) == 4);
    // The two of the common class whose sizes differ most, 1 and 1.3, are the first to go.
    for (const Correspondence& pair : cut.pairs()) {
      CHECK_FALSE((value(pair.query) == 0 && value(pair.candidate) == 3));
    }
  }
}
