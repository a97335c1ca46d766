// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <topobag/adaptors/fleet/fleet_version.hpp>
#include <topobag/adaptors/fleet/uuid.hpp>

#include "bag/realistic_graphs.hpp"

/// Key frames of 12 objects, each of a session of its robot's.
inline std::vector<topobag::FleetVersion> some_fleet_versions(std::size_t count) {
  std::mt19937 random(1);
  std::vector<topobag::TopologyGraph<>> graphs;
  for (int i = 0; i < 500; ++i) graphs.push_back(realistic_graph(random, 12, false));
  const topobag::Uuid robot = topobag::random_uuid(), session = topobag::random_uuid();
  topobag::EntryInfo info;
  info.T_world_camera = Eigen::Isometry3d(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  std::vector<topobag::FleetVersion> versions;
  for (std::size_t i = 0; i < count; ++i) {
    info.stamp = static_cast<double>(i);
    info.T_world_camera->translation().x() = static_cast<double>(i) / 10.0;
    versions.push_back(topobag::version_of({"hall", robot, session, topobag::KeyframeId{i}}, info,
                                           graphs[i % graphs.size()]));
    versions.back().seq = static_cast<std::int64_t>(i) + 1;
  }
  return versions;
}
