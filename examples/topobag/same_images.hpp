// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/graph/topology_graph.hpp>

namespace program {

/// Whether two key frames of one time were made of the same images, by whatever options: their
/// graphs are the same, or cameras saw both from one pose. The origin is where many sequences
/// begin, at the time 0, and says nothing.
inline bool are_of_same_images(const topobag::TopologyGraph<>& a,
                               const std::optional<Eigen::Isometry3d>& T_world_a,
                               const topobag::TopologyGraph<>& b,
                               const std::optional<Eigen::Isometry3d>& T_world_b) {
  constexpr double rounding = 1e-6;  // of a pose that a file keeps, m and rad
  if (T_world_a && T_world_b && !a.views().empty() && !b.views().empty() &&
      !T_world_a->isApprox(Eigen::Isometry3d::Identity(), rounding)) {
    const Eigen::Isometry3d T_a_b = T_world_a->inverse() * *T_world_b;
    if (T_a_b.isApprox(Eigen::Isometry3d::Identity(), rounding)) return true;
  }
  return topobag::encode(a) == topobag::encode(b);
}

}  // namespace program
