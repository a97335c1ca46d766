// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/matching/consistency_similarity.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"
#include "random_graphs.hpp"
#include "similarity/laws.hpp"
#include "similarity/small_graphs.hpp"

using namespace topobag;

namespace {

const ConsistencySimilarity similarity;

/// A cup at the origin, a book 3 m to the right, a tv `up` m above it.
TopologyGraph<> corner(double up) {
  return graph_of({node_at(1), node_at(2, 3.0), node_at(3, 0.0, up)});
}

}  // namespace

TEST_CASE("geometric consistency keeps the laws of a similarity", "[matching][similarity]") {
  laws::check_definition(similarity);
  laws::check_node_order(similarity);
  laws::check_motion(similarity);
  laws::check_foreign_classes(similarity);
  laws::check_floats(similarity);
  laws::check_extremes(similarity);
}

TEST_CASE("geometric consistency of small graphs by hand", "[matching][similarity]") {
  // A leg 4 cm longer, and with it the hypotenuse, from 5 m to the root of 9 + 4.04².
  const double leg = 0.04, hypotenuse = std::sqrt(9.0 + 4.04 * 4.04) - 5.0;
  const auto agreement = [](double d) { return std::exp(-d * d / (2.0 * 0.075 * 0.075)); };
  CHECK(similarity(corner(4.0), corner(4.04)) ==
        Approx((1.0 + agreement(leg) + agreement(hypotenuse)) / 3.0));

  // A leg that is too long: the tv goes with neither of the others, two of three agree exactly.
  CHECK(similarity(corner(4.0), corner(6.0)) == Approx(2.0 / 3.0));

  // One object in common, of one and of three.
  CHECK(similarity(corner(4.0), graph_of({node_at(2, 9.0)})) == Approx(1.0 / 3.0));

  // Another object in one of them: three of four.
  CHECK(similarity(corner(4.0), graph_of({node_at(1), node_at(2, 3.0), node_at(3, 0.0, 4.0),
                                          node_at(4, 1.0)})) == Approx(0.75));
}

TEST_CASE("geometric consistency pairs nodes without a position by class",
          "[matching][similarity]") {
  SemanticNode<> cup = node_at(1), book = node_at(2);
  cup.position.reset();
  book.position.reset();
  const TopologyGraph<> p = graph_of({node_at(3), node_at(3, 1.0), cup, cup, book});
  const TopologyGraph<> q = graph_of({node_at(3), node_at(3, 1.0), cup});
  CHECK(similarity(p, q) == Approx(3.0 / 5.0));
  CHECK(similarity(graph_of({cup}), graph_of({node_at(1)})) == 0.0);

  ConsistencySimilarity grouped;
  grouped.matching.consistency.classes.join(ClassId{1}, ClassId{2});
  CHECK(grouped(graph_of({cup}), graph_of({book})) == 1.0);
  CHECK(grouped(graph_of({node_at(1)}), graph_of({node_at(2)})) == 1.0);
}

TEST_CASE("a mirror image is as consistent as the original", "[matching][similarity]") {
  std::mt19937 random(3);
  const TopologyGraph<> graph = noisy_graph(random, 7, 3);
  CHECK(similarity(graph, mirrored(graph)) == Approx(1.0));
}

TEST_CASE("where a budget ends first the laws still hold to the last bit",
          "[matching][similarity]") {
  ConsistencySimilarity hasty;
  hasty.matching.max_steps = 3;
  hasty.matching.consistency.max_pairs = 40;
  std::mt19937 random(4);
  std::vector<TopologyGraph<>> graphs;
  for (std::size_t round = 0; round < 12; ++round) {
    graphs.push_back(noisy_graph(random, 5 + round, 2, 0.3));
  }
  std::size_t cut = 0;
  for (const auto& p : graphs) {
    CHECK(hasty(p, p) == 1.0);
    for (const auto& q : graphs) {
      const double s = hasty(p, q);
      if (s != similarity(p, q)) ++cut;
      CHECK(hasty(q, p) == s);
      CHECK(hasty(permuted(p, random_order(random, p.size())), q) == s);
    }
  }
  CHECK(cut > 20);
}
