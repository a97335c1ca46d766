// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <topobag/bag/detail/index/camera_grid.hpp>
#include <topobag/bag/place_count.hpp>
#include <topobag/bag/savable_graph.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A graph's objects by class; none are told of a graph that is not topobag's.
template <typename Graph>
ClassCounts objects_of([[maybe_unused]] const Graph& graph) {
  if constexpr (is_topology_graph_v<Graph>) return class_counts(graph.nodes());
  return {};
}

/// Where a bag's entries stand: counted by place, and found by region.
class EntryPlaces {
 public:
  void add(KeyframeId id, const EntryInfo& info, const ClassCounts& objects) {
    count_.add(id, info, objects);
    cameras_.add(id, info);
  }
  /// Precondition: it was added with the same arguments.
  void remove(KeyframeId id, const EntryInfo& info, const ClassCounts& objects) {
    count_.remove(id, info, objects);
    cameras_.remove(id, info);
  }
  /// The same entry elsewhere.
  void move(KeyframeId id, EntryInfo& info, const ClassCounts& objects,
            const Eigen::Isometry3d& T_world_camera) {
    remove(id, info, objects);
    info.T_world_camera = T_world_camera;
    add(id, info, objects);
  }
  void clear() noexcept {
    count_.clear();
    cameras_.clear();
  }

  const PlaceCount& count() const noexcept { return count_; }
  const CameraGrid& cameras() const noexcept { return cameras_; }

 private:
  PlaceCount count_;
  CameraGrid cameras_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
