// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

// A hint tells `DelaunayTriangulation` from which vertex to start walking to a position. It changes
// how fast an answer comes, never the answer. A user's own hint is any copyable type with `suggest`
// and `notice` as below; queries call both from several threads at once.

/// Starts from the vertex used last: O(1) for queries close to each other, O(√n) for random ones.
class LastUsedVertexHint {
 public:
  LastUsedVertexHint() = default;
  LastUsedVertexHint(const LastUsedVertexHint& other) noexcept : last_(other.last_.load(relaxed)) {}
  LastUsedVertexHint& operator=(const LastUsedVertexHint& other) noexcept {
    last_.store(other.last_.load(relaxed), relaxed);
    return *this;
  }

  /// A vertex that may be close to `position`; it may be gone by now.
  std::optional<NodeIndex> suggest(const Eigen::Vector2d& /*position*/) const noexcept {
    const std::uint32_t last = last_.load(relaxed);
    if (last == none) return std::nullopt;
    return node_index(last);
  }

  /// Called with each vertex that an insertion or a query ends at.
  void notice(NodeIndex vertex) const noexcept {
    last_.store(static_cast<std::uint32_t>(vertex), relaxed);
  }

 private:
  static constexpr std::memory_order relaxed = std::memory_order_relaxed;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  mutable std::atomic<std::uint32_t> last_{none};
};

/// Starts from a hierarchy of ever sparser triangulations: O(log n) for any query, at some cost for
/// each insertion and removal. Pays from about 10⁴ vertices on with queries all over the place.
class HierarchyHint {
 public:
  /// None: the hierarchy starts by itself.
  std::optional<NodeIndex> suggest(const Eigen::Vector2d& /*position*/) const noexcept {
    return std::nullopt;
  }
  /// Nothing has to be kept.
  void notice(NodeIndex /*vertex*/) const noexcept {}
};

namespace detail {

template <typename Hint, typename = void>
struct is_hint : std::false_type {};
template <typename Hint>
struct is_hint<Hint, std::void_t<decltype(std::declval<const Hint&>().suggest(
                                     std::declval<const Eigen::Vector2d&>())),
                                 decltype(std::declval<const Hint&>().notice(NodeIndex{}))>>
    : std::bool_constant<std::is_convertible_v<decltype(std::declval<const Hint&>().suggest(
                                                   std::declval<const Eigen::Vector2d&>())),
                                               std::optional<NodeIndex>> &&
                         std::is_default_constructible_v<Hint> &&
                         std::is_copy_constructible_v<Hint> && std::is_copy_assignable_v<Hint>> {};

}  // namespace detail

/// Whether `Hint` serves a `DelaunayTriangulation` (C++20: `concept Hint`).
template <typename Hint>
inline constexpr bool is_hint_v = detail::is_hint<Hint>::value;

}  // namespace v0
}  // namespace topobag
