// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: the scalar of nodes and graphs is a floating-point type.
// MISFIT 2: topobag: the scalar of nodes and graphs is a floating-point type.
// MISFIT 3: topobag: the scalar of a camera is a floating-point type.
#include <topobag/edges/knn_edges.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/pinhole_camera.hpp>

using namespace topobag;

#if MISFIT
using Scalar = int;
#else
using Scalar = float;
#endif

int main() {
#if MISFIT <= 1
  const TopologyGraph<Scalar> graph;
#endif
#if MISFIT == 0 || MISFIT == 2
  const auto made = make_topology_graph(std::vector<SemanticNode<Scalar>>(3), KnnEdges{});
#endif
#if MISFIT == 0 || MISFIT == 3
  const PinholeCamera<Scalar> camera{500, 500, 319, 239, 640, 480};
#endif
}
