// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/node_noise.hpp>

#include "random_graphs.hpp"

inline constexpr double half_a_turn = 3.14159265358979323846;  // rad

/// A view of a room with some boxes in it, anywhere and turned anyhow.
inline topobag::View<> random_view(std::mt19937& random) {
  std::uniform_real_distribution<double> metres(-5.0, 5.0), unit(0.0, 1.0);
  topobag::View<> view;
  view.T_graph_camera =
      Eigen::AngleAxisd(half_a_turn * unit(random),
                        Eigen::Vector3d(metres(random), metres(random), 0.1).normalized())
          .toRotationMatrix();
  view.T_graph_camera.translation() =
      Eigen::Vector3d(metres(random), metres(random), metres(random));
  view.camera = {517.3, 516.5, 318.6, 255.3, 640, 480};
  std::uniform_int_distribution<int> boxes(0, 6);
  for (int i = boxes(random); i > 0; --i) {
    view.occluders.push_back({topobag::box_around({640.0 * unit(random), 480.0 * unit(random)},
                                                  200.0 * unit(random), 200.0 * unit(random)),
                              unit(random) < 0.3 ? 0.0 : 5.0 * unit(random)});
  }
  return view;
}

/// A graph such as a front end makes: noise of the model, single frames and fused ones, views.
inline topobag::TopologyGraph<> realistic_graph(std::mt19937& random, std::size_t count,
                                                bool with_views = true) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<topobag::SemanticNode<>> nodes = random_nodes(random, count, 80, false);
  for (auto& node : nodes) {
    node.confidence = unit(random);
    node.existence = unit(random) < 0.5 ? 1.0 : 0.01 + 0.99 * unit(random);
    if (!node.position || unit(random) < 0.1) continue;
    node.covariance = (0.2 + unit(random)) * topobag::NodeNoise{}.covariance(
                                                 *node.position, node.size, unit(random) < 0.3);
  }
  std::vector<topobag::View<>> views;
  if (with_views) {
    for (int i = 0; i < 3; ++i) views.push_back(random_view(random));
  }
  return topobag::make_topology_graph(std::move(nodes), topobag::KnnEdges{3}, std::move(views));
}
