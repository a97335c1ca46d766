// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <topobag/similarity/similarity.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Stands where a similarity needs nothing kept.
struct Nothing {
  void clear() noexcept {}
};

/// What a bag keeps of an entry to compare it: a descriptor, its slot in an index, or nothing.
template <typename Similarity, typename Graph, bool = has_descriptor_v<Similarity, Graph>,
          bool = is_jaccard_v<Similarity>>
struct EntryKey {
  using type = Nothing;
};
template <typename Similarity, typename Graph>
struct EntryKey<Similarity, Graph, true, false> {
  using type = descriptor_t<Similarity, Graph>;
};
template <typename Similarity, typename Graph>
struct EntryKey<Similarity, Graph, true, true> {
  using type = std::size_t;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
