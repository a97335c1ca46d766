// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include <topobag/graph/bearing.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/recognition/locate_by_bearings.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/recognition/recognition_options.hpp>

namespace topobag {
inline namespace v0 {

/// What is seen in a frame that tracking is lost in: a graph, where objects have depths, and their
/// directions, which are asked by where too few have (`locate_by_bearings`). Either may be missing.
struct LostSight {
  std::optional<TopologyGraph<>> graph;     ///< of the objects with a depth
  std::optional<BearingSighting> bearings;  ///< of all objects

  /// Nothing is seen, or a graph alone.
  LostSight(std::optional<TopologyGraph<>> seen = std::nullopt) : graph(std::move(seen)) {}
  /// The same.
  LostSight(std::nullopt_t) {}
  /// Both.
  LostSight(std::optional<TopologyGraph<>> seen, std::optional<BearingSighting> directions)
      : graph(std::move(seen)), bearings(std::move(directions)) {}

  /// Whether the graph has too few objects for a pose, so that directions are all there is.
  bool is_without_depth() const noexcept {
    return bearings.has_value() && !(graph && graph->is_matchable());
  }
};

namespace detail {

/// Where in a relocalizer's map a graph was taken.
template <typename Relocalizer>
Recognition located(const Relocalizer& relocalizer, const TopologyGraph<>& query,
                    const RecognitionOptions& options) {
  return relocalizer.localize(query, options);
}

/// The same by directions alone.
template <typename Relocalizer>
Recognition located(const Relocalizer& relocalizer, const BearingSighting& query,
                    const RecognitionOptions& options) {
  return locate_by_bearings(relocalizer.map(), query, options);
}

}  // namespace detail

}  // namespace v0
}  // namespace topobag
