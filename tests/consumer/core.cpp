// SPDX-License-Identifier: MIT
// What a program on topobag::core is made of; compiled by each project here in its own way.
#include <iostream>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/edges/knn_edges.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/version.hpp>

using namespace topobag;

int main() {
  const ClassCatalog catalog = ClassCatalog::coco80();
  const std::vector<Detection> detections{{{100.0, 100.0, 180.0, 160.0}, catalog.at("tv"), 0.9},
                                          {{300.0, 200.0, 360.0, 280.0}, catalog.at("chair"), 0.8},
                                          {{420.0, 90.0, 480.0, 150.0}, catalog.at("book"), 0.7}};
  const auto wall = [](const Eigen::Vector2d&) -> std::optional<double> { return 2.0; };
  const PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, 640, 480};
  const auto lifted = lift_detections(detections, wall, camera, catalog);

  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{7}, make_topology_graph(lifted.nodes, KnnEdges{}));
  const auto found = bag.query(*bag.find(KeyframeId{7}));
  if (found.size() != 1 || found[0].id != KeyframeId{7} || found[0].similarity < 0.999) return 1;
  std::cout << "topobag " << TOPOBAG_VERSION_MAJOR << '.' << TOPOBAG_VERSION_MINOR << ": found\n";
}
