// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <topobag/graph/gravity.hpp>
#include <topobag/graph/view.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// What one camera shows of one moment: its nodes, and the view with all that may hide an object
/// from it.
struct KeyframeSighting {
  double stamp = 0.0;                 ///< s
  std::vector<SemanticNode<>> nodes;  ///< in the key frame's camera frame
  View<> view;                        ///< its camera, what hides things from it, how far it sees
  /// Which way is down in its camera frame, where the front end knows.
  std::optional<Gravity<>> gravity = std::nullopt;
};

}  // namespace v0
}  // namespace topobag
