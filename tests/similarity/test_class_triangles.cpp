// SPDX-License-Identifier: MIT
#include <topobag/similarity/class_triangles.hpp>

#include "catch.hpp"
#include "similarity/small_graphs.hpp"

using namespace topobag;

namespace {

/// Right-angled with legs of 3 and 4 m; opposite sides 5 (first corner), 4, 3.
TopologyGraph<> triangle(int right_angle, int along_x, int along_y, double leg_x = 3.0) {
  return graph_of({node_at(right_angle), node_at(along_x, leg_x), node_at(along_y, 0.0, 4.0)});
}

}  // namespace

TEST_CASE("class triangles on hand-computed numbers", "[similarity]") {
  ClassTriangles similarity;
  similarity.bin_width = 1.0;
  similarity.max_distance = 100.0;
  CHECK(similarity(triangle(1, 2, 3), triangle(1, 2, 3)) == 1.0);
  // The same sides with two classes exchanged: the classes' three votes of .1 remain.
  CHECK(similarity(triangle(1, 2, 3), triangle(1, 3, 2)) == Approx(0.3 / (2.6 - 0.3)));
  // A leg of 0 m makes the other two sides 4 m.
  CHECK(similarity(triangle(1, 2, 3), triangle(1, 2, 3, 0.0)) == Approx(0.3 / (2.6 - 0.3)));
}

TEST_CASE("a side between two bins votes for both", "[similarity]") {
  ClassTriangles similarity;
  similarity.bin_width = 1.0;
  similarity.max_distance = 100.0;
  // Collinear: sides 2.25, 2 and .25 against 2, 2 and 0: shares .75 · 1 · .75 in common.
  const auto p = graph_of({node_at(1), node_at(2, 2.0), node_at(3, 2.25)});
  const auto q = graph_of({node_at(1), node_at(2, 2.0), node_at(3, 2.0)});
  const double common = 0.3 + 0.75 * 0.75;
  CHECK(similarity(p, q) == Approx(common / (2.6 - common)));
}

TEST_CASE("corners of one class may change places", "[similarity]") {
  const ClassTriangles similarity;
  CHECK(similarity(triangle(1, 1, 2),
                   graph_of({node_at(1, 3.0), node_at(1), node_at(2, 0.0, 4.0)})) == 1.0);
}
