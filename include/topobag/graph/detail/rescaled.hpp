// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include <topobag/error.hpp>
#include <topobag/graph/scaled_graph.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

template <typename Graph, typename = void>
inline constexpr bool is_scalable_v = false;
template <typename Graph>
inline constexpr bool
    is_scalable_v<Graph, std::void_t<decltype(scaled(std::declval<const Graph&>(), 1.0))>> = true;

/// A graph in another unit of length; the graph itself, which then has to stay, where the unit is
/// its own. Throws as `scaled`, and InvalidValue for a kind of graph that has no such function.
template <typename Graph>
class Rescaled {
 public:
  /// @param scale  new units in one of the graph's
  Rescaled(const Graph& graph, double scale) : own_(graph) {
    if (scale == 1.0) return;
    if constexpr (is_scalable_v<Graph>) {
      other_.emplace(scaled(graph, scale));
    } else {
      throw InvalidValue("a graph of a kind without scaled(graph, factor) stays in its unit");
    }
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
