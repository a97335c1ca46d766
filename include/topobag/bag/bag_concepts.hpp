// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/query.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// A bag's graph; no type when it is none of ours.
template <typename Bag>
using GraphOf = std::enable_if_t<
    std::is_same_v<typename Bag::Graph, TopologyGraph<typename Bag::Graph::Scalar>>,
    typename Bag::Graph>;

template <typename Bag, typename = void>
struct is_searchable_bag : std::false_type {};
template <typename Bag>
struct is_searchable_bag<
    Bag,
    std::enable_if_t<std::is_convertible_v<decltype(std::declval<const Bag&>().query(
                                               std::declval<const GraphOf<Bag>&>(),
                                               std::declval<const QueryOptions&>())),
                                           std::vector<Candidate>> &&
                     std::is_convertible_v<decltype(std::declval<const Bag&>().find(KeyframeId{})),
                                           std::optional<GraphOf<Bag>>>>> : std::true_type {};

template <typename Bag, typename = void>
struct is_growing_bag : std::false_type {};
template <typename Bag>
struct is_growing_bag<Bag,
                      std::void_t<decltype(std::declval<Bag&>().add(
                          KeyframeId{}, std::declval<GraphOf<Bag>>(), std::declval<EntryInfo>()))>>
    : std::true_type {};

/// Whether `Bag` shows its entries as key frames with such a graph.
template <typename Bag, typename Graph, typename = void>
inline constexpr bool shows_entries_v = false;
template <typename Bag, typename Graph>
inline constexpr bool
    shows_entries_v<Bag, Graph,
                    std::void_t<decltype(std::declval<const Bag&>().for_each(
                        std::declval<void (*)(KeyframeId, const EntryInfo&, const Graph&)>()))>> =
        true;

/// Of a bag that is merged into another. To be asked within a static_assert, which comes first.
template <typename Bag, typename Graph>
constexpr bool require_entries() {
  static_assert(shows_entries_v<Bag, Graph>,
                "topobag: a bag to merge has for_each, of KeyframeId, EntryInfo and Graph.");
  return true;
}

template <typename Bag, typename = void>
struct is_stored_bag : std::false_type {};
template <typename Bag>
struct is_stored_bag<Bag, std::enable_if_t<shows_entries_v<Bag, GraphOf<Bag>>>>
    : std::is_convertible<decltype(std::declval<const Bag&>().size()), std::uint64_t> {};

template <typename Bag, typename = void>
struct is_durable_bag : std::false_type {};
template <typename Bag>
struct is_durable_bag<
    Bag,
    std::enable_if_t<
        std::is_convertible_v<decltype(std::declval<const Bag&>().contains(KeyframeId{})), bool> &&
        std::is_convertible_v<decltype(std::declval<Bag&>().erase(KeyframeId{})), bool> &&
        std::is_void_v<std::void_t<decltype(std::declval<Bag&>().update(
            KeyframeId{}, std::declval<GraphOf<Bag>>(), std::declval<EntryInfo>()))>>>>
    : is_growing_bag<Bag> {};

}  // namespace detail

/// Whether key frames can be looked up in `Bag`: `Relocalizer` (C++20: `concept SearchableBag`).
///
/// To decide, `verify_candidates` asks for `info(id)` as well. Where `Bag` also has `places()`,
/// `places_holding(objects, groups)` and `within(region)`, as the library's bags do, decisions go
/// by them. Without, a map counts as many places as a query has candidates, so that a large one
/// accepts more falsely than the rate says, all of them can hold what was matched, and the place
/// around a candidate takes another `query`.
template <typename Bag>
inline constexpr bool is_searchable_bag_v = detail::is_searchable_bag<Bag>::value;

/// Whether key frames can be put into `Bag`: `LoopDetector`, `load` (C++20: `concept GrowingBag`).
template <typename Bag>
inline constexpr bool is_growing_bag_v = detail::is_growing_bag<Bag>::value;

/// Whether `Bag` can be walked through: `save` (C++20: `concept StoredBag`).
template <typename Bag>
inline constexpr bool is_stored_bag_v = detail::is_stored_bag<Bag>::value;

/// Whether `SqliteBag` can fill `Bag` (C++20: `concept DurableBag`).
template <typename Bag>
inline constexpr bool is_durable_bag_v = detail::is_durable_bag<Bag>::value;

}  // namespace v0
}  // namespace topobag
