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

  /// All of it.
  std::size_t total() const noexcept { return graphs + index + entries; }
};

}  // namespace v0
}  // namespace topobag
