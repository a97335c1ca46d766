// SPDX-License-Identifier: MIT
#include <topobag/topobag.hpp>

std::size_t nodes_in_first();

int main() {
  return nodes_in_first() ==
                 topobag::DelaunayEdges2<>{}(std::vector<topobag::SemanticNode<double>>{}).size()
             ? 0
             : 1;
}
