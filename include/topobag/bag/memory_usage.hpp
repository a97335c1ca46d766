// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// Where the memory of a bag goes, bytes.
struct MemoryUsage {
  std::size_t graphs = 0;   ///< encoded
  std::size_t index = 0;    ///< what makes queries fast
  std::size_t entries = 0;  ///< ids, infos and the rest
  std::size_t nodes = 0;    ///< objects in the graphs: a count, no bytes

  /// All of it.
  std::size_t total() const noexcept { return graphs + index + entries; }

  /// What an object takes on average; of the graphs alone, `graphs` over `nodes`. 0 without any.
  double bytes_per_node() const noexcept {
    return nodes == 0 ? 0.0 : static_cast<double>(total()) / static_cast<double>(nodes);
  }
};

}  // namespace v0
}  // namespace topobag
