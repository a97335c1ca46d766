// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// Whether `S` is a similarity of graphs: callable as `s(const Graph&, const Graph&) -> double`
/// (C++20: `concept Similarity`). Nothing else is asked of a user's own.
///
/// The library's own keep to these laws. For non-empty graphs S(P, Q) lies in [0, 1], S(P, P) = 1,
/// and S(P, Q) = S(Q, P) to the last bit; the order of the nodes does not matter. S of an empty
/// graph and anything is 0. No result is NaN. Where a definition breaks a law, its docstring says
/// so.
template <typename S, typename Graph>
inline constexpr bool is_similarity_v =
    std::is_invocable_r_v<double, const S&, const Graph&, const Graph&>;

namespace detail {

template <typename S, typename Graph, typename = void>
struct has_descriptor : std::false_type {};

template <typename S, typename Graph>
struct has_descriptor<
    S, Graph,
    std::void_t<decltype(std::declval<const S&>().descriptor(std::declval<const Graph&>()))>>
    : std::is_convertible<decltype(std::declval<const S&>().similarity(
                              std::declval<const S&>().descriptor(std::declval<const Graph&>()),
                              std::declval<const S&>().descriptor(std::declval<const Graph&>()))),
                          double> {};

}  // namespace detail

/// Whether `S` works in two steps, `s.similarity(s.descriptor(p), s.descriptor(q)) == s(p, q)`: who
/// compares a graph often computes its descriptor once.
template <typename S, typename Graph>
inline constexpr bool has_descriptor_v = detail::has_descriptor<S, Graph>::value;

/// Whether the descriptors of `S` are `SparseHistogram`s without negative weights, and `jaccard` is
/// what it compares them by: a bag then reads of its entries only what they have in common with a
/// query. To be specialised; what derives from such an `S` is not one by that.
template <typename S>
inline constexpr bool is_jaccard_v = false;

/// The type of `s.descriptor(graph)`.
template <typename S, typename Graph>
using descriptor_t =
    std::decay_t<decltype(std::declval<const S&>().descriptor(std::declval<const Graph&>()))>;

}  // namespace v0
}  // namespace topobag
