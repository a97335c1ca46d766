// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: an edge builder is callable as builder(const
// MISFIT 2: topobag: an edge builder is callable as builder(const
// MISFIT 3: topobag: an edge builder is callable as builder(const
#include <topobag/graph/local_graph.hpp>

using namespace topobag;

struct Builder {
#if MISFIT == 1
  int operator()(const std::vector<SemanticNode<>>&) const { return 0; }
#elif MISFIT == 2
  EdgeList operator()(const std::vector<SemanticNode<>>&) { return {}; }  // not const
#elif MISFIT == 3
  EdgeList operator()(const SemanticNode<>&) const { return {}; }
#else
  EdgeList operator()(const std::vector<SemanticNode<>>&) const { return {}; }
#endif
};

int main() {
#if MISFIT != 3
  const auto graph = make_topology_graph(std::vector<SemanticNode<>>{}, Builder{});
#endif
  const auto fused = LocalGraph<>().graph(Builder{});
}
