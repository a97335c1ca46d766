// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/entry_info.hpp>
#include <topobag/edges/knn_edges.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/node_noise.hpp>

/// Objects in a room, and what a camera in it sees: all of them, exactly.
class SyntheticRoom {
 public:
  SyntheticRoom(unsigned seed, std::size_t objects, int classes) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> metres(-1.5, 1.5), size(0.1, 0.4);
    std::uniform_int_distribution<int> label(0, classes - 1);
    for (std::size_t i = 0; i < objects; ++i) {
      const double x = metres(random), y = metres(random), z = 4.0 + metres(random);
      const double width = size(random), height = size(random);
      objects_.push_back({topobag::ClassId{label(random)}, {x, y, z}, {width, height}});
    }
  }

  topobag::TopologyGraph<> seen_from(const Eigen::Isometry3d& T_room_camera) const {
    std::vector<topobag::SemanticNode<>> nodes;
    for (const Object& object : objects_) {
      topobag::SemanticNode<> node;
      node.label = object.label;
      node.position = T_room_camera.inverse() * object.position;
      node.z = node.position->z();
      node.size = object.size;
      node.covariance = topobag::NodeNoise{}.covariance(*node.position, node.size, false);
      nodes.push_back(node);
    }
    return topobag::make_topology_graph(std::move(nodes), topobag::KnnEdges{});
  }

 private:
  struct Object {
    topobag::ClassId label;
    Eigen::Vector3d position;  // m
    Eigen::Vector2d size;      // m
  };
  std::vector<Object> objects_;
};

/// A camera about the room's origin, looking along z.
inline Eigen::Isometry3d random_camera(std::mt19937& random) {
  std::uniform_real_distribution<double> metres(-0.5, 0.5), radians(-0.3, 0.3);
  const double x = metres(random), y = metres(random), z = metres(random);
  const double a = radians(random), b = radians(random);
  return Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(a, Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(b, Eigen::Vector3d::UnitY());
}

/// Of a key frame that was taken there.
inline topobag::EntryInfo standing_at(const Eigen::Isometry3d& T_world_camera,
                                      std::uint32_t session = 0) {
  topobag::EntryInfo info;
  info.session = session;
  info.T_world_camera = T_world_camera;
  return info;
}
