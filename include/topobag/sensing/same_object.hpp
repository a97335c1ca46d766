// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Whether two nodes, of whatever class, are one object by their place and size alone: detectors
/// give one thing two boxes (a tv and a laptop, a couch and a chair).
struct SameObject {
  double max_distance = 0.2;    ///< share of the smaller object's size
  double max_size_ratio = 1.7;  ///< larger over smaller

  /// False when a position or a size is unknown.
  template <typename Scalar>
  bool operator()(const SemanticNode<Scalar>& a, const SemanticNode<Scalar>& b) const {
    if (!a.position || !b.position) return false;
    const double size_a = static_cast<double>(a.size.norm());
    const double size_b = static_cast<double>(b.size.norm());
    const double smaller = std::min(size_a, size_b);
    if (std::max(size_a, size_b) > max_size_ratio * smaller) return false;
    return static_cast<double>((*a.position - *b.position).norm()) < max_distance * smaller;
  }
};

}  // namespace v0
}  // namespace topobag
