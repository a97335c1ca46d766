// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/recognition/relocalizer.hpp>

#include "random_appearance.hpp"
#include "synthetic_room.hpp"

/// Rooms 20 m apart, each visited twice, whose objects have looks of their own, seen with noise.
/// Entry 2 r + v is visit v of room r.
struct RoomsWithLooks {
  static constexpr std::size_t objects = 8;

  explicit RoomsWithLooks(unsigned rooms,
                          topobag::AppearanceKind kind_ = topobag::AppearanceKind("made up", 16))
      : kind(kind_), random(rooms) {
    for (unsigned room = 0; room < rooms; ++room) {
      for (std::size_t i = 0; i < objects; ++i) looks.push_back(direction());
      for (unsigned visit = 0; visit < 2; ++visit) visit_room(room);
    }
  }

  /// What is seen of a room from a random camera.
  topobag::TopologyGraph<> seen(unsigned room, const Eigen::Isometry3d& T_room_camera) {
    const auto graph = SyntheticRoom(room, objects, 4).seen_from(T_room_camera);
    std::vector<topobag::SemanticNode<>> nodes = graph.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::VectorXd look = looks[room * objects + i] + 0.3 * direction();
      nodes[i].appearance = topobag::Appearance(kind, look);
    }
    return topobag::TopologyGraph<>(std::move(nodes), graph.edges());
  }

  /// A map of all visits.
  topobag::Relocalizer<> relocalizer(topobag::RecognitionOptions options = {}) const {
    topobag::Relocalizer<> made(std::move(options));
    for (std::size_t i = 0; i < graphs.size(); ++i) made.map().add(ids[i], graphs[i], infos[i]);
    return made;
  }

  topobag::AppearanceKind kind;
  std::mt19937 random;
  std::vector<Eigen::VectorXd> looks;  ///< of all objects, room by room
  std::vector<topobag::KeyframeId> ids;
  std::vector<topobag::TopologyGraph<>> graphs;
  std::vector<topobag::EntryInfo> infos;

 private:
  Eigen::VectorXd direction() {
    std::normal_distribution<double> normal;
    Eigen::VectorXd vector(static_cast<Eigen::Index>(kind.length()));
    for (Eigen::Index i = 0; i < vector.size(); ++i) vector(i) = normal(random);
    return vector.normalized();
  }

  void visit_room(unsigned room) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    topobag::EntryInfo info =
        standing_at(Eigen::Translation3d(20.0 * room, 0.0, 0.0) * T_room_camera);
    info.stamp = 100.0 * static_cast<double>(ids.size());
    ids.push_back(topobag::KeyframeId{ids.size()});
    graphs.push_back(seen(room, T_room_camera));
    infos.push_back(info);
  }
};
