// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <topobag/bag/query.hpp>

namespace topobag {
inline namespace v0 {

/// The answer of an index, with what it took.
struct SearchResult {
  std::vector<Candidate> candidates;  ///< best first, ties by id
  std::size_t entries = 0;            ///< in the bag
  std::size_t visited = 0;            ///< entries whose graphs were read
  bool exact = true;                  ///< false when the budget ended the search
  double missed_similarity = 0.0;     ///< of what is left unvisited, at most; 0 if exact

  /// How many graphs were never touched.
  std::size_t untouched() const noexcept { return entries - visited; }
};

}  // namespace v0
}  // namespace topobag
