// SPDX-License-Identifier: MIT
// What needs topobag::topobag, that is, CGAL.
#include <vector>

#include <topobag/edges/delaunay_edges2.hpp>

int main() {
  std::vector<topobag::SemanticNode<>> nodes(3);
  nodes[0].pixel = {0.0, 0.0};
  nodes[1].pixel = {100.0, 0.0};
  nodes[2].pixel = {0.0, 100.0};
  return topobag::DelaunayEdges2<>{}(nodes).size() == 3 ? 0 : 1;
}
