// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <topobag/graph/scaled_graph.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A graph in another unit of length; the graph itself, which then has to stay, where the unit is
/// its own.
template <typename Graph>
class Rescaled {
 public:
  /// @param scale  new units in one of the graph's
  Rescaled(const Graph& graph, double scale) : own_(graph) {
    if (scale != 1.0) other_ = scaled(graph, scale);
  }
  Rescaled(const Rescaled&) = delete;
  Rescaled& operator=(const Rescaled&) = delete;

  const Graph& operator*() const noexcept { return other_ ? *other_ : own_; }

 private:
  const Graph& own_;
  std::optional<Graph> other_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
