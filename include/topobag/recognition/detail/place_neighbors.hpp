// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/query.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/recognition/detail/keyframe_motion.hpp>
#include <topobag/recognition/detail/session_order.hpp>
#include <topobag/recognition/detail/stored_entry.hpp>
#include <topobag/recognition/place_options.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A key frame of the map beside the candidate, and where its camera stood.
template <typename Bag>
struct Neighbor {
  decltype(stored_graph(std::declval<const Bag&>(), KeyframeId{}, 0)) graph;  ///< is there
  Eigen::Isometry3d T_candidate_neighbor;
};

/// The key frames whose cameras stand in a region, by the bag's own word; of one that does not
/// tell, those that answer a query of it, which are admitted already.
template <typename Bag>
auto keyframes_within(const Bag& bag, const typename Bag::Graph&, const QueryOptions&,
                      const MapRegion& region, int) -> decltype(bag.within(region)) {
  return bag.within(region);
}
template <typename Bag>
std::vector<KeyframeId> keyframes_within(const Bag& bag, const typename Bag::Graph& query,
                                         QueryOptions retrieval, const MapRegion& region, long) {
  if (!retrieval.among.region) retrieval.among.region = region;
  retrieval.max_results = std::numeric_limits<std::size_t>::max();
  retrieval.min_similarity = 0.0;
  std::vector<KeyframeId> ids;
  for (const Candidate& candidate : bag.query(query, retrieval)) ids.push_back(candidate.id);
  return ids;
}

/// How far apart two cameras stand and look, m.
template <typename Pose>
double camera_distance(const Pose& a, const Pose& b, const PlaceOptions& options) {
  const Pose between = a.inverse() * b;
  return between.translation().norm() +
         options.turn_weight * Eigen::AngleAxisd(between.linear()).angle();
}

/// Whether two key frames, both with poses, are images of one film that show the same.
template <typename Info>
bool repeats(const Info& a, const Info& b, const PlaceOptions& options) {
  return a.session == b.session &&
         camera_distance(*a.T_world_camera, *b.T_world_camera, options) < options.spacing;
}

/// How many other key frames of the map show again what this one does.
template <typename Bag>
std::size_t repeated_views(const Bag& bag, KeyframeId id, const EntryInfo& info,
                           const typename Bag::Graph& query, const QueryOptions& retrieval,
                           const PlaceOptions& options) {
  if (!info.T_world_camera) return 0;
  const MapRegion region{info.T_world_camera->translation(), options.spacing};
  std::size_t count = 0;
  for (const KeyframeId near : keyframes_within(bag, query, retrieval, region, 0)) {
    const auto there = stored_info(bag, near, 0);
    if (near != id && retrieval.admits(near, *there) && repeats(info, *there, options)) ++count;
  }
  return count;
}

/// By the world's poses: those whose cameras stood and looked most nearly as the query's.
/// @param candidate  with a pose
template <typename Bag>
std::vector<Neighbor<Bag>> neighbors_by_pose(const Bag& bag, KeyframeId id,
                                             const EntryInfo& candidate,
                                             const Eigen::Isometry3d& T_candidate_query,
                                             const typename Bag::Graph& query,
                                             const QueryOptions& retrieval,
                                             const PlaceOptions& options) {
  const Eigen::Isometry3d T_world_query = *candidate.T_world_camera * T_candidate_query;
  const MapRegion region{T_world_query.translation(), options.radius};
  std::vector<std::pair<double, KeyframeId>> nearest;
  for (const KeyframeId near : keyframes_within(bag, query, retrieval, region, 0)) {
    if (near == id) continue;
    const auto info = stored_info(bag, near, 0);
    if (!retrieval.admits(near, *info)) continue;
    const Eigen::Isometry3d& T_world_near = *info->T_world_camera;
    if (!region.contains(T_world_near.translation())) continue;
    nearest.emplace_back(camera_distance(T_world_query, T_world_near, options), near);
  }
  std::sort(nearest.begin(), nearest.end());
  std::vector<EntryInfo> fused{candidate};
  std::vector<Neighbor<Bag>> neighbors;
  for (const auto& [distance, near] : nearest) {
    if (neighbors.size() == options.max_keyframes) break;
    auto info = *stored_info(bag, near, 0);
    const bool known = std::any_of(fused.begin(), fused.end(), [&](const EntryInfo& other) {
      return repeats(other, info, options);
    });
    if (known) continue;
    neighbors.push_back(
        {stored_graph(bag, near, 0), candidate.T_world_camera->inverse() * *info.T_world_camera});
    fused.push_back(std::move(info));
  }
  return neighbors;
}

/// Without poses: those that come next to the candidate in its session, where they match it.
template <typename Bag>
std::vector<Neighbor<Bag>> neighbors_by_id(const Bag& bag, KeyframeId id, const EntryInfo& info,
                                           const typename Bag::Graph& candidate,
                                           const QueryOptions& retrieval,
                                           const MatchOptions& matching,
                                           const PlaceOptions& options) {
  std::vector<Neighbor<Bag>> neighbors;
  const auto before = next_of_session(bag, id, info, false, options.max_neighbors);
  const auto after = next_of_session(bag, id, info, true, options.max_neighbors);
  for (std::size_t step = 0; step < std::max(before.size(), after.size()); ++step) {
    for (const auto* side : {&before, &after}) {
      if (step >= side->size()) continue;
      const KeyframeId near = (*side)[step];
      auto graph = stored_graph(bag, near, 0);
      if (!graph || !retrieval.admits(near, *stored_info(bag, near, 0))) continue;
      const auto T_candidate_neighbor = motion_by_objects(candidate, *graph, matching);
      if (T_candidate_neighbor) neighbors.push_back({std::move(graph), *T_candidate_neighbor});
    }
  }
  return neighbors;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
