// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <topobag/assert.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/match_nodes.hpp>

namespace topobag {
inline namespace v0 {

/// Geometric consistency as a similarity: the share of the objects that lie alike.
///
/// The largest set of class-compatible node pairs whose mutual distances all agree (the maximum
/// clique of Bailey, Nebot, Rosenblatt, Durrant-Whyte, ICRA 2000; CLIPPER, Lusk, Fathian, How, ICRA
/// 2021, relaxes it) has q pairs. With a the mean of exp(−Δ² / 2σ²) over the differences Δ of their
/// distances, 1 for fewer than two pairs, S = (q a + u) / max(n, k). Distances say nothing of nodes
/// without a position: u of them pair up by class alone.
///
/// Uses neither pixels nor edges and does not change with the camera's motion. A mirror image is as
/// good as the original and chance agreement counts like any other: what a match is worth,
/// `verify_candidates` says. When the search's budget ends first, S is that of the largest set
/// seen, still the same in both orders of the arguments and any order of the nodes. Descriptor O(n
/// log n); similarity that of `match_nodes`.
struct ConsistencySimilarity {
  MatchNodesOptions matching{};  ///< how the sets are searched
  double sigma = 0.075;          ///< m, > 0; of the difference of two distances that agree

  /// All that the matching reads of a node: class; position, covariance, size.
  using Object = std::tuple<ClassId, std::array<double, 14>>;

  /// A graph in an order that does not depend on the nodes'.
  struct Descriptor {
    std::vector<Object> objects;    ///< with a position, ascending
    TopologyGraph<double> placed;   ///< the same as a graph without edges
    std::vector<ClassId> unplaced;  ///< classes of the other nodes, ascending
  };

  template <typename Scalar>
  Descriptor descriptor(const TopologyGraph<Scalar>& graph) const {
    Descriptor result;
    std::vector<std::pair<Object, SemanticNode<double>>> sorted;
    for (const auto& node : graph.nodes()) {
      if (!node.position) {
        result.unplaced.push_back(node.label);
        continue;
      }
      SemanticNode<double> object;
      object.label = node.label;
      object.position = node.position->template cast<double>();
      object.covariance = node.covariance.template cast<double>();
      object.size = node.size.template cast<double>();
      sorted.emplace_back(key_of(object), object);
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::sort(result.unplaced.begin(), result.unplaced.end());
    std::vector<SemanticNode<double>> nodes;
    for (auto& [object, node] : sorted) {
      result.objects.push_back(object);
      nodes.push_back(std::move(node));
    }
    result.placed = TopologyGraph<double>(std::move(nodes));
    return result;
  }

  template <typename Described = Descriptor>
  double similarity(const Described& p, const Described& q) const {
    const auto all_of = [](const Described& d) { return std::tie(d.objects, d.unplaced); };
    if (all_of(q) < all_of(p)) return similarity(q, p);
    const std::size_t larger = std::max(size_of(p), size_of(q));
    if (larger == 0) return 0.0;
    if (all_of(p) == all_of(q)) return 1.0;  // whatever the search's budget
    const NodeMatching match = match_nodes(p.placed, q.placed, matching);
    const double found =
        static_cast<double>(match.pairs.size()) * agreement(p.placed, q.placed, match.pairs) +
        static_cast<double>(common(p.unplaced, q.unplaced));
    return found / static_cast<double>(larger);
  }

  template <typename Scalar>
  double operator()(const TopologyGraph<Scalar>& p, const TopologyGraph<Scalar>& q) const {
    return similarity(descriptor(p), descriptor(q));
  }

 private:
  static std::size_t size_of(const Descriptor& d) { return d.objects.size() + d.unplaced.size(); }

  template <typename Node>
  static Object key_of(const Node& node) {
    Object object{node.label, {}};
    auto& numbers = std::get<1>(object);
    Eigen::Map<Eigen::Vector3d>(numbers.data()) = *node.position;
    Eigen::Map<Eigen::Matrix3d>(numbers.data() + 3) = node.covariance;
    Eigen::Map<Eigen::Vector2d>(numbers.data() + 12) = node.size;
    return object;
  }

  template <typename Graph>
  double agreement(const Graph& p, const Graph& q, const std::vector<Correspondence>& pairs) const {
    TOPOBAG_ASSERT(sigma > 0.0);
    if (pairs.size() < 2) return 1.0;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (std::size_t j = i + 1; j < pairs.size(); ++j, ++count) {
        const double difference = distance(p, pairs[i].candidate, pairs[j].candidate) -
                                  distance(q, pairs[i].query, pairs[j].query);
        sum += std::exp(-0.5 * difference * difference / (sigma * sigma));
      }
    }
    return sum / static_cast<double>(count);
  }

  template <typename Graph>
  static double distance(const Graph& graph, NodeIndex a, NodeIndex b) {
    return (*graph.node(a).position - *graph.node(b).position).norm();
  }

  /// How many unplaced nodes of the two graphs pair up within their classes' groups.
  std::size_t common(const std::vector<ClassId>& p, const std::vector<ClassId>& q) const {
    std::map<ClassId, std::pair<std::size_t, std::size_t>> counts;
    for (const ClassId label : p) ++counts[matching.consistency.classes.group(label)].first;
    for (const ClassId label : q) ++counts[matching.consistency.classes.group(label)].second;
    std::size_t pairs = 0;
    for (const auto& [group, count] : counts) pairs += std::min(count.first, count.second);
    return pairs;
  }
};

}  // namespace v0
}  // namespace topobag
