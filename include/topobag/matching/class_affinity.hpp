// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// How readily an object that the map calls `candidate` is called `query` by the query's detector,
/// in [0, 1]: 1 = another name of the same thing, 0 = never. It need be neither symmetric nor
/// transitive: a mug may be a cup and a cup a bowl, and a mug no bowl. Never asked of a class and
/// itself.
///
///     options.consistency.affinity = affinity;  // which pairs are offered
///     options.chance.affinity = affinity;       // what they cost: −log10 of it
using ClassAffinity = std::function<double(ClassId candidate, ClassId query)>;

namespace detail {

/// 1 of equal classes, else what the user says; 0 where that is nothing. Throws InvalidValue for
/// what is not in [0, 1].
inline double affinity_of(ClassId candidate, ClassId query, const ClassAffinity& affinity) {
  if (candidate == query) return 1.0;
  if (!affinity) return 0.0;
  const double said = affinity(candidate, query);
  if (!(said >= 0.0 && said <= 1.0)) {
    throw InvalidValue("the affinity of the classes " + std::to_string(value(candidate)) + " and " +
                       std::to_string(value(query)) + " is " + std::to_string(said) +
                       ", which is not in [0, 1]");
  }
  return said;
}

/// Whether one of the two nodes may be of several classes.
template <typename Scalar>
bool has_weights(const SemanticNode<Scalar>& a, const SemanticNode<Scalar>& b) noexcept {
  return !a.label_weights.empty() || !b.label_weights.empty();
}

/// Calls `visit(class, weight)` for the classes that a node may be of.
template <typename Scalar, typename Visit>
void for_each_label(const SemanticNode<Scalar>& node, const Visit& visit) {
  if (node.label_weights.empty()) visit(node.label, 1.0);
  for (std::size_t i = 0; i < node.label_weights.size(); ++i) {
    visit(node.label_weights.label(i), static_cast<double>(node.label_weights.byte(i)));
  }
}

/// Σ of the products of the weights of two nodes' classes, times the classes' affinity.
template <typename Scalar>
double common_weight(const SemanticNode<Scalar>& a, const SemanticNode<Scalar>& b,
                     const ClassAffinity& affinity) {
  double sum = 0.0;
  for_each_label(a, [&](ClassId label_a, double weight_a) {
    for_each_label(b, [&](ClassId label_b, double weight_b) {
      sum += weight_a * weight_b * affinity_of(label_a, label_b, affinity);
    });
  });
  return sum;
}

}  // namespace detail

/// The affinity of two nodes, in [0, 1]. Where each is of one class it is that of the classes.
/// Where one may be of several it is how probable it is that the two were called one thing, over
/// the geometric mean of how probable that is of each and itself, so that an object that is as
/// uncertain in both costs nothing. O(5² calls).
/// @param affinity  none: only equal classes have one
template <typename Scalar>
double label_affinity(const SemanticNode<Scalar>& candidate, const SemanticNode<Scalar>& query,
                      const ClassAffinity& affinity = {}) {
  if (!detail::has_weights(candidate, query)) {
    return detail::affinity_of(candidate.label, query.label, affinity);
  }
  const double common = detail::common_weight(candidate, query, affinity);
  const double alone = detail::common_weight(candidate, candidate, affinity) *
                       detail::common_weight(query, query, affinity);
  return std::min(1.0, common / std::sqrt(alone));
}

/// Whether two nodes may be one object by their classes: where there is an affinity, it alone
/// decides, and has to reach `min_affinity`; else those of one group may, and those whose label
/// weights reach it.
template <typename Scalar>
bool may_be_one(const SemanticNode<Scalar>& candidate, const SemanticNode<Scalar>& query,
                const ClassGroups& groups, const ClassAffinity& affinity, double min_affinity) {
  if (!affinity && groups.compatible(candidate.label, query.label)) return true;
  if (!affinity && !detail::has_weights(candidate, query)) return false;
  const double reached = label_affinity(candidate, query, affinity);
  return reached > 0.0 && reached >= min_affinity;
}

/// What the labels of a pair cost, in decades: −log10 of their affinity, and for two classes of one
/// group no more than `in_group` where there is no affinity of the user's. Infinite for those that
/// have nothing in common.
template <typename Scalar>
double label_cost(const SemanticNode<Scalar>& candidate, const SemanticNode<Scalar>& query,
                  const ClassGroups& groups, const ClassAffinity& affinity, double in_group) {
  const double reached = label_affinity(candidate, query, affinity);
  const double cost =
      reached > 0.0 ? -std::log10(reached) : std::numeric_limits<double>::infinity();
  const bool grouped = !affinity && candidate.label != query.label &&
                       groups.compatible(candidate.label, query.label);
  return grouped ? std::min(cost, in_group) : cost;
}

/// `groups` with the classes joined that `pairs` take for one another by an affinity, or by the
/// weights of their labels; nothing where no pair does.
/// @param pairs  a range of `Correspondence` between the nodes of the two graphs
/// O(pairs · classes).
template <typename Pairs, typename Graph>
std::optional<ClassGroups> joined_by(const Pairs& pairs, const Graph& candidate, const Graph& query,
                                     const ClassGroups& groups, const ClassAffinity& affinity) {
  std::optional<ClassGroups> joined;
  for (const auto& pair : pairs) {
    const auto& p = candidate.node(pair.candidate);
    const auto& q = query.node(pair.query);
    if ((joined ? *joined : groups).compatible(p.label, q.label)) continue;
    if (!(label_affinity(p, q, affinity) > 0.0)) continue;
    if (!joined) joined = groups;
    joined->join(p.label, q.label);
  }
  return joined;
}

}  // namespace v0
}  // namespace topobag
