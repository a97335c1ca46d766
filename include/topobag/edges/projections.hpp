// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

// A projection takes the nodes and returns a callable `node -> std::optional<Eigen::Vector2d>`:
// where the node lies in the plane that planar edge builders triangulate, empty if nowhere.
// A user's own projection is any callable of that shape.

/// The paper's plane (section 3.3.2): box centres (u, v), px. Nodes without a pixel have no place.
struct ImagePlane {
  template <typename Scalar>
  auto operator()(const std::vector<SemanticNode<Scalar>>&) const noexcept {
    return [](const SemanticNode<Scalar>& node) -> std::optional<Eigen::Vector2d> {
      if (!node.pixel) return std::nullopt;
      return node.pixel->template cast<double>();
    };
  }
};

}  // namespace v0
}  // namespace topobag
