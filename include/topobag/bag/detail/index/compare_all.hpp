// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <topobag/bag/query.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The best entries by asking each: the oracle of every index. O(n · score).
/// @param entries   a map from ids to pointers to entries with an `info`
/// @param score_of  of an entry, in [0, 1]
template <typename Entries, typename ScoreOf>
std::vector<Candidate> compare_all(const Entries& entries, const QueryOptions& options,
                                   const ScoreOf& score_of) {
  std::vector<Candidate> found;
  for (const auto& [id, entry] : entries) {
    if (!options.admits(id, entry->info)) continue;
    const double score = score_of(*entry);
    if (score >= options.min_similarity) found.push_back({id, score});
  }
  const std::size_t kept = std::min(options.max_results, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept), found.end());
  found.resize(kept);
  return found;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
