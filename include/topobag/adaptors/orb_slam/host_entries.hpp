// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include <topobag/adaptors/orb_slam/host_worlds.hpp>
#include <topobag/adaptors/orb_slam/lost_sight.hpp>
#include <topobag/bag/camera_poses.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/recognition/verdict.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// The graphs of a host's key frames, and where their cameras stand: what recognition asks. Not
/// synchronised.
template <typename Bag = BagOfTopologyGraphs<>>
class HostEntries {
 public:
  using Graph = typename Bag::Graph;

  /// None yet.
  explicit HostEntries(RecognitionOptions recognition) : relocalizer_(std::move(recognition)) {}

  /// What they are asked by. The poses of its map are those of `HostWorlds`.
  const Relocalizer<Bag>& relocalizer() const noexcept { return relocalizer_; }

  /// From the next query on.
  void set_options(RecognitionOptions recognition) {
    relocalizer_.set_options(std::move(recognition));
  }

  /// A copy of the entries of one of the host's maps, with the options, which lives on without
  /// this: to calibrate by, or to look into. O(n · add).
  /// @param map  null for hosts with one alone
  Relocalizer<Bag> copy_of(const void* map) const {
    Relocalizer<Bag> copy(relocalizer_.options());
    const auto& bag = relocalizer_.map();
    for (const auto& [id, camera] : cameras_) {
      if (camera.map != map) continue;
      const KeyframeId key_frame{id};
      copy.map().add(key_frame, *bag.find(key_frame), *bag.info(key_frame));
    }
    return copy;
  }

  /// Those that are there.
  std::size_t size() const noexcept { return relocalizer_.map().size(); }

  /// Puts a key frame's graph in, or anew. One that cannot be matched only takes an older one's
  /// place. Throws as the bag's `add`.
  /// @param camera  as the graph was fused from it
  void put(std::uint64_t id, Graph graph, EntryInfo info, const HostCamera& camera) {
    Bag& bag = relocalizer_.map();
    info.T_world_camera = worlds_.T_world_camera(camera);
    if (bag.contains(KeyframeId{id})) {
      bag.update(KeyframeId{id}, std::move(graph), std::move(info));
    } else if (graph.is_matchable()) {
      bag.add(KeyframeId{id}, std::move(graph), std::move(info));
    } else {
      return;
    }
    cameras_[id] = camera;
  }

  /// Moves those that are there and stand elsewhere by what the host says now, graphs and all that
  /// was asked of them left alone. O(cameras + moved · log n).
  /// @param cameras  by key frame; their poses are rigid motions
  void move(const std::map<std::uint64_t, HostCamera>& cameras) {
    CameraPoses moved;
    for (const auto& [id, camera] : cameras) {
      const auto known = cameras_.find(id);
      if (known == cameras_.end() || stand_alike(known->second, camera)) continue;
      moved.emplace(KeyframeId{id}, worlds_.T_world_camera(camera));
      known->second = camera;
    }
    relocalizer_.map().set_poses(moved);
  }

  /// Where a query was taken: a graph, or a `BearingSighting`.
  template <typename Query>
  Recognition localize(const Query& query, const RecognitionOptions& options) const {
    return detail::located(relocalizer_, query, options);
  }

  /// Takes a key frame out, if it is there.
  void erase(std::uint64_t id) {
    relocalizer_.map().erase(KeyframeId{id});
    cameras_.erase(id);
  }

  void clear() {
    relocalizer_.map().clear();
    cameras_.clear();
    worlds_.clear();
  }

 private:
  static bool stand_alike(const HostCamera& a, const HostCamera& b) {
    return a.map == b.map && a.T_map_camera.matrix() == b.T_map_camera.matrix();
  }

  Relocalizer<Bag> relocalizer_;
  HostWorlds worlds_;
  std::map<std::uint64_t, HostCamera> cameras_;  ///< as the bag has them
};

}  // namespace v0
}  // namespace topobag
