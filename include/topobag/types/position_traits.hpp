// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Where a vertex of a planar triangulation lies. Specialise it for your own type, with
/// `static Eigen::Vector2d position(const Vertex&)`; the position may not change while stored.
template <typename Vertex, typename Enable = void>
struct PositionTraits;

/// A 2-vector of any scalar is its own position.
template <typename Scalar, int Options>
struct PositionTraits<Eigen::Matrix<Scalar, 2, 1, Options>> {
  static Eigen::Vector2d position(const Eigen::Matrix<Scalar, 2, 1, Options>& vertex) {
    return vertex.template cast<double>();
  }
};

/// A node lies at its pixel (u, v); without one it has no position: NaN, which is refused.
template <typename Scalar>
struct PositionTraits<SemanticNode<Scalar>> {
  static Eigen::Vector2d position(const SemanticNode<Scalar>& node) {
    if (!node.pixel) return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    return node.pixel->template cast<double>();
  }
};

namespace detail {
template <typename Vertex, typename = void>
struct HasPosition : std::false_type {};
template <typename Vertex>
struct HasPosition<
    Vertex, std::void_t<decltype(PositionTraits<Vertex>::position(std::declval<const Vertex&>()))>>
    : std::is_convertible<decltype(PositionTraits<Vertex>::position(std::declval<const Vertex&>())),
                          Eigen::Vector2d> {};
}  // namespace detail

/// Whether `PositionTraits<Vertex>` fits. In C++20: a concept.
template <typename Vertex>
inline constexpr bool has_position_v = detail::HasPosition<Vertex>::value;

}  // namespace v0
}  // namespace topobag
