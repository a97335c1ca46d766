// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include <topobag/graph/bearing.hpp>
#include <topobag/graph/topology_graph.hpp>

/// What a camera without depth sees of a graph's nodes: their directions and how large they look.
/// @param noise  rad about each axis, and half of it again of the logarithm of a size
inline topobag::BearingSighting bearings_of(const topobag::TopologyGraph<>& graph,
                                            std::mt19937& random, double noise) {
  std::normal_distribution<double> normal;
  topobag::BearingSighting sighting;
  for (const auto& node : graph.nodes()) {
    topobag::Bearing bearing;
    bearing.label = node.label;
    const Eigen::Vector3d true_direction = node.position->normalized();
    const Eigen::Vector3d across = true_direction.unitOrthogonal();
    const double a = noise * normal(random), b = noise * normal(random);
    bearing.direction =
        (true_direction + a * across + b * true_direction.cross(across)).normalized();
    bearing.deviation = std::max(noise, 1e-3);
    bearing.extent = node.size / node.position->z() * std::exp(0.5 * noise * normal(random));
    sighting.sources.push_back(sighting.bearings.size());
    sighting.bearings.push_back(bearing);
  }
  return sighting;
}
