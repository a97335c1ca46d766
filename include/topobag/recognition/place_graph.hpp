// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/query.hpp>
#include <topobag/graph/local_graph.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/match_graphs.hpp>
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

/// By the world's poses: those whose cameras stood and looked most nearly as the query's.
template <typename Bag>
std::vector<Neighbor<Bag>> neighbors_by_pose(const Bag& bag, KeyframeId id,
                                             const Eigen::Isometry3d& T_world_candidate,
                                             const Eigen::Isometry3d& T_candidate_query,
                                             const typename Bag::Graph& query,
                                             const QueryOptions& retrieval,
                                             const PlaceOptions& options) {
  const Eigen::Isometry3d T_world_query = T_world_candidate * T_candidate_query;
  const MapRegion region{T_world_query.translation(), options.radius};
  std::vector<std::pair<double, KeyframeId>> nearest;
  for (const KeyframeId near : keyframes_within(bag, query, retrieval, region, 0)) {
    if (near == id) continue;
    const auto info = bag.info(near);
    if (!retrieval.admits(near, *info)) continue;
    const Eigen::Isometry3d between = T_world_query.inverse() * *info->T_world_camera;
    const double distance = between.translation().norm();
    if (distance > options.radius) continue;
    const double turn = Eigen::AngleAxisd(between.linear()).angle();
    nearest.emplace_back(distance + options.turn_weight * turn, near);
  }
  const std::size_t kept = std::min(options.max_keyframes, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(kept),
                    nearest.end());
  nearest.resize(kept);
  std::vector<Neighbor<Bag>> neighbors;
  for (const auto& [distance, near] : nearest) {
    neighbors.push_back({stored_graph(bag, near, 0),
                         T_world_candidate.inverse() * *bag.info(near)->T_world_camera});
  }
  return neighbors;
}

/// Without poses: those whose ids are next to the candidate's in its session, where they match it.
template <typename Bag>
std::vector<Neighbor<Bag>> neighbors_by_id(const Bag& bag, KeyframeId id, const EntryInfo& info,
                                           const typename Bag::Graph& candidate,
                                           const QueryOptions& retrieval,
                                           const MatchOptions& matching,
                                           const PlaceOptions& options) {
  std::vector<Neighbor<Bag>> neighbors;
  for (std::size_t step = options.max_neighbors; step > 0; --step) {
    for (const bool before : {true, false}) {
      const KeyframeId near{before ? value(id) - step : value(id) + step};
      const auto there = stored_info(bag, near, 0);
      if (!there || there->session != info.session || !retrieval.admits(near, *there)) continue;
      auto graph = stored_graph(bag, near, 0);
      if (!graph) continue;
      const GraphMatch match = match_graphs(candidate, *graph, matching);
      const bool sure = !match.poses.empty() && !match.poses.front().degenerate &&
                        match.poses.front().support() >= 3.0;  // odds of a thousand to one
      if (sure) neighbors.push_back({std::move(graph), match.poses.front().T_candidate_query});
    }
  }
  return neighbors;
}

}  // namespace detail

/// The objects of the map around a candidate, fused over the key frames that stood there, in the
/// candidate's frame: as far as the query looks, that is in its cameras' field or near its objects.
///
/// One graph shows what one camera detected; the place shows what is there: more for a true pose to
/// agree with, and more for a false one to miss. The neighbours are found by the world's poses;
/// without them, by their ids in the candidate's session and by matching them with it. Without any,
/// the place is the candidate's graph. Entries that `retrieval` does not admit are left out.
/// O(key frames within the region + key frames that are fused · objects²); a bag without `within`
/// is asked by a query of the region.
template <typename Bag>
typename Bag::Graph place_graph(const Bag& bag, KeyframeId id, const typename Bag::Graph& candidate,
                                const typename Bag::Graph& query,
                                const Eigen::Isometry3d& T_candidate_query,
                                const QueryOptions& retrieval = {},
                                const MatchOptions& matching = {},
                                const PlaceOptions& options = {}) {
  using Scalar = typename Bag::Graph::Scalar;
  using Pose = typename LocalGraph<Scalar>::Pose;
  std::vector<detail::Neighbor<Bag>> neighbors;
  if (const auto info = detail::stored_info(bag, id, 0)) {
    neighbors =
        info->T_world_camera
            ? detail::neighbors_by_pose(bag, id, *info->T_world_camera, T_candidate_query, query,
                                        retrieval, options)
            : detail::neighbors_by_id(bag, id, *info, candidate, retrieval, matching, options);
  }
  if (neighbors.empty()) return candidate;

  LocalGraphOptions fusing = options.fusing;
  fusing.window = std::numeric_limits<double>::infinity();
  LocalGraph<Scalar> local(fusing);
  double order = 0.0;
  Eigen::Isometry3d T_candidate_previous = Eigen::Isometry3d::Identity();
  const auto add = [&](const auto& graph, const Eigen::Isometry3d& T_candidate_added) {
    // The newest view is the key frame's own camera.
    View<Scalar> view = graph.views().empty() ? View<Scalar>{} : graph.views().back();
    const Pose moved(
        (T_candidate_previous.inverse() * T_candidate_added).matrix().template cast<Scalar>());
    local.add(order++, graph.nodes(), moved, std::move(view));
    T_candidate_previous = T_candidate_added;
  };
  // The farthest first, and the candidate, whose frame it is to be, last.
  for (auto it = neighbors.rbegin(); it != neighbors.rend(); ++it) {
    add(*it->graph, it->T_candidate_neighbor);
  }
  add(candidate, Eigen::Isometry3d::Identity());
  const auto fused = local.graph([](const auto&) { return EdgeList{}; });

  const Eigen::Isometry3d T_query_candidate = T_candidate_query.inverse();
  std::vector<SemanticNode<Scalar>> nodes;
  for (const SemanticNode<Scalar>& node : fused.nodes()) {
    const Eigen::Vector3d in_query = T_query_candidate * node.position->template cast<double>();
    const auto point = in_query.cast<Scalar>().eval();
    const bool looked_at =
        std::any_of(query.views().begin(), query.views().end(), [&](const View<Scalar>& view) {
          return view.in_field(point, Scalar(0), static_cast<Scalar>(options.max_depth));
        });
    const bool near_object =
        looked_at ||
        std::any_of(query.nodes().begin(), query.nodes().end(), [&](const auto& other) {
          return other.position &&
                 (other.position->template cast<double>() - in_query).norm() < options.margin;
        });
    if (near_object) nodes.push_back(node);
  }
  return typename Bag::Graph(std::move(nodes), {}, fused.views(), candidate.gravity());
}

}  // namespace v0
}  // namespace topobag
