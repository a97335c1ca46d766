// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/edges/edge_list.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/gravity.hpp>
#include <topobag/graph/view.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Semantic nodes joined by edges of metric length: the paper's topology graph (3.3).
///
/// Immutable once made. Positions are in the camera frame of the graph's key frame, metres.
template <typename Scalar_ = double>
class TopologyGraph {
 public:
  using Scalar = Scalar_;
  using Node = SemanticNode<Scalar>;

  TopologyGraph() = default;

  /// @param nodes    in the order in which they are to be kept (the paper: the detector's)
  /// @param edges    made canonical here; an edge at a node without a position has no length and is
  /// left out
  /// @param views    the cameras that looked for the nodes; may be empty (see `View`)
  /// @param gravity  which way is down, in the graph's frame, where it is known
  /// Throws InvalidValue with the node's or edge's index for a number that is not finite, a
  /// covariance that is neither zero nor positive definite, label weights whose best is not the
  /// label, an appearance of another kind than that of a node before, an edge from a node to
  /// itself, or an end beyond the nodes; and as `View::validate`, and `normalized` of the gravity.
  /// O(n + m log m).
  explicit TopologyGraph(std::vector<Node> nodes, EdgeList edges = {},
                         std::vector<View<Scalar>> views = {},
                         std::optional<Gravity<Scalar>> gravity = std::nullopt)
      : nodes_(std::move(nodes)), views_(std::move(views)) {
    if (gravity) gravity_ = normalized(*gravity);
    for (const View<Scalar>& view : views_) view.validate();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      require_valid(nodes_[i], i);
      appearance_kind_ = common_kind(appearance_kind_, nodes_[i].appearance.kind(), "node", i);
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (edges[i].a == edges[i].b || value(edges[i].a) >= nodes_.size() ||
          value(edges[i].b) >= nodes_.size()) {
        throw InvalidValue(
            "edge " + std::to_string(i) + " does not join two different nodes of the graph", i);
      }
      const Edge edge = make_edge(edges[i].a, edges[i].b);
      if (node(edge.a).position && node(edge.b).position) edges_.push_back(edge);
    }
    make_canonical(edges_);
    lengths_.reserve(edges_.size());
    for (const Edge& edge : edges_) {
      lengths_.push_back((*node(edge.a).position - *node(edge.b).position).norm());
    }
  }

  /// In the order in which they were given.
  const std::vector<Node>& nodes() const noexcept { return nodes_; }
  /// Precondition: the graph has it.
  const Node& node(NodeIndex i) const noexcept { return nodes_[value(i)]; }
  std::size_t size() const noexcept { return nodes_.size(); }
  bool empty() const noexcept { return nodes_.empty(); }

  /// Canonical: a < b, sorted, each once.
  const EdgeList& edges() const noexcept { return edges_; }

  /// d_ij of eq. 4, m, parallel to `edges()`.
  const std::vector<Scalar>& lengths() const noexcept { return lengths_; }

  /// The cameras that looked for the nodes, in the graph's frame.
  const std::vector<View<Scalar>>& views() const noexcept { return views_; }

  /// Which way is down, in the graph's frame; nothing where it is not known.
  const std::optional<Gravity<Scalar>>& gravity() const noexcept { return gravity_; }

  /// The one kind of the descriptors that nodes carry; of length 0 where none carries one.
  AppearanceKind appearance_kind() const noexcept { return appearance_kind_; }

  /// Whether there is enough to look a place up: three nodes with a position. Where both graphs
  /// know which way is down two determine a pose (`match_graphs`), but they hardly outweigh chance:
  /// of 1,403 single frames and 2,005 windows of 3 s in a map of the same rooms and others, the
  /// best score of two objects is 1.48 under a true pose and 1.02 under a false one, and a map of
  /// one place already asks for 1.75 (`DecisionOptions::threshold`).
  bool is_matchable() const noexcept {
    std::size_t placed = 0;
    for (const Node& n : nodes_) placed += n.position ? 1U : 0U;
    return placed >= 3;
  }

 private:
  static void require_valid(const Node& node, std::size_t index) {
    const bool finite = (!node.pixel || node.pixel->allFinite()) && std::isfinite(node.z) &&
                        (!node.position || node.position->allFinite()) &&
                        node.covariance.allFinite() && node.size.allFinite() &&
                        std::isfinite(node.confidence) && std::isfinite(node.existence);
    if (!finite) {
      throw InvalidValue("node " + std::to_string(index) + " holds a number that is not finite",
                         index);
    }
    if (!node.covariance.isZero(Scalar(0)) && !is_positive_definite(node.covariance)) {
      throw InvalidValue("node " + std::to_string(index) +
                             " has a covariance that is not positive definite; zero = not modelled",
                         index);
    }
    if (!has_best_label(node.label, node.label_weights)) {
      throw InvalidValue(
          "node " + std::to_string(index) + " has label weights whose best is not its label",
          index);
    }
  }

  /// By Sylvester's criterion.
  static bool is_positive_definite(const typename Node::Matrix3& matrix) noexcept {
    const Eigen::Matrix3d m = matrix.template cast<double>();
    return m(0, 0) > 0.0 && m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0) > 0.0 &&
           m.col(0).dot(m.col(1).cross(m.col(2))) > 0.0;
  }

  std::vector<Node> nodes_;
  EdgeList edges_;
  std::vector<Scalar> lengths_;
  std::vector<View<Scalar>> views_;
  std::optional<Gravity<Scalar>> gravity_;
  AppearanceKind appearance_kind_;
};

/// Whether `Builder` is an edge builder over nodes of `Scalar` (C++20: `concept EdgeBuilder`).
template <typename Builder, typename Scalar>
inline constexpr bool is_edge_builder_v =
    std::is_invocable_r_v<EdgeList, const Builder&, const std::vector<SemanticNode<Scalar>>&>;

/// The graph of `nodes` with the edges that `builder` finds. The gravity's scalar is the nodes'.
template <typename Scalar, typename Builder>
TopologyGraph<Scalar> make_topology_graph(
    std::vector<SemanticNode<Scalar>> nodes, const Builder& builder,
    std::vector<View<Scalar>> views = {},
    std::optional<Gravity<std::common_type_t<Scalar>>> gravity = std::nullopt) {
  static_assert(
      is_edge_builder_v<Builder, Scalar>,
      "topobag: an edge builder is callable as builder(const std::vector<SemanticNode<Scalar>>&) "
      "-> EdgeList.");
  EdgeList edges = builder(nodes);
  return TopologyGraph<Scalar>(std::move(nodes), std::move(edges), std::move(views), gravity);
}

#ifdef TOPOBAG_COMPILED  // in the library topobag::compiled
extern template class TopologyGraph<double>;
#endif

}  // namespace v0
}  // namespace topobag
