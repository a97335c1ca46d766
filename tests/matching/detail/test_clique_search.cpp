// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <topobag/matching/detail/clique_search.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

using VertexSet = std::vector<std::size_t>;

/// Vertices in groups of three, joined at random across groups.
struct GroupedGraph {
  GroupedGraph(std::mt19937& random, std::size_t n, double density) : adjacency(n, n) {
    std::bernoulli_distribution joined(density);
    for (std::size_t v = 0; v < n; ++v) group.push_back(v / 3);
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        if (group[a] == group[b] || !joined(random)) continue;
        adjacency.set(a, b);
        adjacency.set(b, a);
      }
    }
  }

  bool is_clique(const VertexSet& vertices) const {
    for (const std::size_t a : vertices) {
      for (const std::size_t b : vertices) {
        if (a != b && !adjacency.test(a, b)) return false;
      }
    }
    return true;
  }

  bool is_maximal(VertexSet clique) const {
    for (std::size_t v = 0; v < group.size(); ++v) {
      if (std::count(clique.begin(), clique.end(), v) != 0) continue;
      clique.push_back(v);
      if (is_clique(clique)) return false;
      clique.pop_back();
    }
    return true;
  }

  /// All maximal cliques of at least `min_size`, by trying every set of vertices.
  std::set<VertexSet> maximal_cliques(std::size_t min_size) const {
    std::set<VertexSet> found;
    for (std::size_t bits = 1; bits < std::size_t{1} << group.size(); ++bits) {
      VertexSet vertices;
      for (std::size_t v = 0; v < group.size(); ++v) {
        if ((bits >> v) & 1U) vertices.push_back(v);
      }
      if (vertices.size() >= min_size && is_clique(vertices) && is_maximal(vertices)) {
        found.insert(vertices);
      }
    }
    return found;
  }

  detail::BitMatrix adjacency;
  std::vector<std::size_t> group;
};

/// What the search reports, each once.
std::set<VertexSet> reported(const GroupedGraph& graph, std::size_t min_size, std::size_t slack,
                             std::size_t budget) {
  std::set<VertexSet> found;
  detail::CliqueSearch search(graph.adjacency, graph.group);
  search.run(min_size, slack, budget,
             [&](VertexSet clique) { CHECK(found.insert(std::move(clique)).second); });
  return found;
}

}  // namespace

TEST_CASE("the clique search reports every large maximal clique, and nothing else", "[matching]") {
  std::mt19937 random(911);
  for (int round = 0; round < 60; ++round) {
    const GroupedGraph graph(random, 12, 0.2 + 0.1 * (round % 7));
    const std::size_t slack = static_cast<std::size_t>(round % 3);
    auto expected = graph.maximal_cliques(2);
    std::size_t largest = 0;
    for (const VertexSet& clique : expected) largest = std::max(largest, clique.size());
    auto found = reported(graph, 2, slack, 100000);
    for (const VertexSet& clique : found) CHECK(expected.count(clique) == 1);
    const auto too_small = [&](const VertexSet& clique) { return clique.size() + slack < largest; };
    for (auto* cliques : {&expected, &found}) {
      for (auto it = cliques->begin(); it != cliques->end();) {
        it = too_small(*it) ? cliques->erase(it) : std::next(it);
      }
    }
    CHECK(found == expected);
  }
}

TEST_CASE("a clique search without the budget for one reports the greedy one", "[matching]") {
  std::mt19937 random(912);
  for (int round = 0; round < 60; ++round) {
    const GroupedGraph graph(random, 60, 0.5);
    const auto found = reported(graph, 3, 1, 1);
    REQUIRE(found.size() == 1);
    CHECK(graph.is_clique(*found.begin()));
    CHECK(graph.is_maximal(*found.begin()));
  }
}

TEST_CASE("a graph without vertices has no clique", "[matching]") {
  std::mt19937 random(913);
  CHECK(reported(GroupedGraph(random, 0, 0.5), 1, 0, 100).empty());
}
