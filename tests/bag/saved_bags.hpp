// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <sstream>
#include <string>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/snapshot.hpp>
#include <topobag/sensing/node_noise.hpp>

#include "random_graphs.hpp"

/// A bag of `count` graphs with every kind of entry: with and without stamp, pose, nodes and views.
inline topobag::BagOfTopologyGraphs<> random_bag(std::mt19937& random, std::size_t count) {
  topobag::BagOfTopologyGraphs<> bag;
  for (std::size_t i = 0; i < count; ++i) {
    topobag::EntryInfo info;
    info.session = static_cast<std::uint32_t>(random() % 3);
    if (random() % 3 != 0) info.stamp = static_cast<double>(random()) / 7.0;
    if (random() % 3 != 0) {
      info.T_world_camera = Eigen::Isometry3d(Eigen::AngleAxisd(
          static_cast<double>(random() % 300) / 100.0, Eigen::Vector3d(1, 2, 3).normalized()));
      info.T_world_camera->translation() = Eigen::Vector3d(1.0 / 3.0, -2.0, 7.1);
    }
    if (random() % 3 != 0) info.label = "floor " + std::to_string(random() % 4);
    auto nodes = random_nodes(random, random() % 8, 80, false);
    for (auto& node : nodes) {
      if (node.position) {
        node.covariance = topobag::NodeNoise{}.covariance(*node.position, node.size, false);
      }
    }
    std::vector<topobag::View<>> views(random() % 3);
    for (auto& view : views) {
      view.camera = {500.0, 500.0, 320.0, 240.0, 640, 480};
      view.occluders.push_back({{10, 20, 300, 400}, 1.5});
    }
    bag.add(topobag::KeyframeId{i * 1000003u},
            topobag::make_topology_graph(std::move(nodes), topobag::KnnEdges{3}, std::move(views)),
            info);
  }
  return bag;
}

/// The bytes that `save` writes: two bags hold the same when these are the same.
template <typename Bag>
std::string saved(const Bag& bag, const topobag::SaveOptions& options = {}) {
  std::ostringstream stream;
  topobag::save(bag, stream, options);
  return stream.str();
}

/// The bag that `load` reads from these bytes.
inline topobag::BagOfTopologyGraphs<> loaded(const std::string& bytes,
                                             std::uint64_t catalog_fingerprint = 0) {
  std::istringstream stream(bytes);
  return topobag::load<topobag::BagOfTopologyGraphs<>>(stream, catalog_fingerprint);
}
