// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <vector>

#include <topobag/edges/complete_edges.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the complete graph joins every two nodes once", "[edges]") {
  for (std::size_t n = 0; n < 12; ++n) {
    const EdgeList edges = CompleteEdges{}(std::vector<SemanticNode<>>(n));
    CHECK(edges.size() == (n == 0 ? 0 : n * (n - 1) / 2));
    EdgeList canonical = edges;
    make_canonical(canonical);
    CHECK(edges == canonical);
    CHECK(std::all_of(edges.begin(), edges.end(),
                      [&](const Edge& e) { return e.a < e.b && value(e.b) < n; }));
  }
}
