// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: a similarity is callable as similarity(graph, graph) -> double in [0, 1].
// MISFIT 2: topobag: a similarity is callable as similarity(graph, graph) -> double in [0, 1].
#include <string>

#include <topobag/bag/bag_of_topology_graphs.hpp>

using Graph = topobag::TopologyGraph<>;

struct Similarity {
#if MISFIT == 1
  std::string operator()(const Graph&, const Graph&) const { return "much"; }
#elif MISFIT == 2
  double operator()(const Graph&) const { return 1.0; }
#else
  double operator()(const Graph&, const Graph&) const { return 1.0; }
#endif
};

int main() {
  topobag::BagOfTopologyGraphs<Graph, Similarity> bag;
  bag.add(topobag::KeyframeId{1}, Graph());
  return static_cast<int>(bag.query(Graph()).size());
}
