// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>

#include "matching/layouts.hpp"

/// The motion of a camera that stays where it is.
inline const Eigen::Isometry3d still = Eigen::Isometry3d::Identity();

inline topobag::View<> camera_view() {
  topobag::View<> view;
  view.camera = {500.0, 500.0, 319.5, 239.5, 640, 480};
  return view;
}

/// Six objects before a camera that moves sideways and turns, seen with noise in 60 % of the frames
/// (10 a second); from the second second on each frame adds a box on nothing.
class FlickeringScene {
 public:
  static constexpr std::size_t frames = 80;

  explicit FlickeringScene(unsigned seed) : random_(seed) {}

  static std::vector<topobag::SemanticNode<>> things() {
    return {object_at(1, {-0.7, 0.4, 3.0}), object_at(1, {0.6, 0.5, 3.5}),
            object_at(2, {0.0, -0.3, 3.0}), object_at(3, {-0.3, 0.1, 2.5}),
            object_at(4, {0.4, 0.0, 2.6}),  object_at(1, {-0.1, 0.5, 4.0})};
  }

  static Eigen::Isometry3d T_world_camera(std::size_t frame) {
    const double share = static_cast<double>(frame) / static_cast<double>(frames) - 0.5;
    return Eigen::Translation3d(0.8 * share, 0.05 * share, 0) *
           Eigen::AngleAxisd(-0.1 * share, Eigen::Vector3d::UnitY());
  }

  std::vector<topobag::SemanticNode<>> nodes(std::size_t frame) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<topobag::SemanticNode<>> seen;
    for (const auto& thing : things()) {
      if (unit(random_) < 0.6) seen.push_back(thing);
    }
    if (frame >= 10) {
      const double x = unit(random_), y = unit(random_);
      seen.push_back(object_at(5, {x - 0.5, y - 0.5, 1.5}));
    }
    const topobag::TopologyGraph<> in_camera =
        moved(topobag::TopologyGraph<>(seen), T_world_camera(frame).inverse());
    return jittered(random_, in_camera, 1.0).nodes();
  }

  static Eigen::Isometry3d T_previous_current(std::size_t frame) {
    if (frame == 0) return still;
    return T_world_camera(frame - 1).inverse() * T_world_camera(frame);
  }

 private:
  std::mt19937 random_;
};
