// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/sensing/sensor_profile.hpp>

namespace topobag {
inline namespace v0 {

/// An object of one graph that a camera of the other should have seen, and did not.
struct MissingObject {
  NodeIndex node{};                ///< in the graph that holds it
  bool of_candidate = true;        ///< whether the candidate graph holds it, or the query
  std::size_t views = 0;           ///< cameras of the other graph that should have shown it
  std::size_t measured_views = 0;  ///< of those, the ones whose depth says so; the others' boxes do
  double cost = 0.0;               ///< −log10 P(missing | same place)
};

/// Negative evidence: what should have been seen, and was not, speaks against a match. What is out
/// of view, too far away or hidden counts nothing; nor does a graph without views. A view with
/// depth hides what it has not looked through: an object counts where the measured depth lies
/// beyond it, and not where nothing was measured. In a view without, a nearer detected box hides.
struct MissingObjects {
  double max_detection_rate = 0.8;  ///< of one view; even a plain object is overlooked at times
  double correlation = 1.0;         ///< share of a view's oversight that the other views repeat
  double min_probability = 0.4;     ///< of another reason to be missing: moved, hidden, misread
  double image_margin = 40.0;       ///< px from the border within which nothing need show
  double max_depth = default_sensor.sure_range;  ///< m beyond which nothing need show
  double same_spot = 0.1;        ///< m; an object found this near is the same by another name
  double same_spot_share = 0.5;  ///< share of its size that `same_spot` grows by
  double clearance = 0.15;       ///< m that a measured depth lies beyond an object's centre,
                                 ///< plus half its size, where one looks through its place
  std::map<ClassId, double> detection_rates;  ///< of one view, of classes for which it is known;
                                              ///< of others, the object's existence

  /// The missing objects of both graphs under a pose, the candidate's first, ascending. O(nodes ·
  /// (nodes + occluders of the views)).
  template <typename Scalar>
  std::vector<MissingObject> find(const TopologyGraph<Scalar>& candidate,
                                  const TopologyGraph<Scalar>& query,
                                  const std::vector<Correspondence>& inliers,
                                  const Eigen::Isometry3d& T_candidate_query) const {
    std::vector<bool> candidate_matched(candidate.size(), false),
        query_matched(query.size(), false);
    for (const Correspondence& pair : inliers) {
      candidate_matched[value(pair.candidate)] = true;
      query_matched[value(pair.query)] = true;
    }
    std::vector<MissingObject> missing;
    look_for(candidate, candidate_matched, query, T_candidate_query.inverse(), true, missing);
    look_for(query, query_matched, candidate, T_candidate_query, false, missing);
    return missing;
  }

 private:
  template <typename Scalar>
  void look_for(const TopologyGraph<Scalar>& held, const std::vector<bool>& matched,
                const TopologyGraph<Scalar>& other, const Eigen::Isometry3d& T_other_held,
                bool of_candidate, std::vector<MissingObject>& missing) const {
    for (std::size_t i = 0; i < held.size(); ++i) {
      const auto& node = held.nodes()[i];
      if (matched[i] || !node.position) continue;
      const Eigen::Vector3d position = T_other_held * node.position->template cast<double>();
      const double beyond = clearance + 0.5 * static_cast<double>(node.size.norm());
      std::size_t views = 0, measured_views = 0;
      for (const auto& view : other.views()) {
        const auto point = position.template cast<Scalar>().eval();
        const auto margin = static_cast<Scalar>(image_margin);
        const auto far = static_cast<Scalar>(max_depth);
        if (view.depth) {
          if (view.sees_through(point, margin, far, beyond)) ++measured_views;
        } else if (view.should_show(point, margin, far)) {
          ++views;
        }
      }
      views += measured_views;
      if (views == 0 || found_by_another_name(node, position, other)) continue;
      const double rate = std::min(max_detection_rate, detection_rate(node));
      const double looks = 1.0 + (static_cast<double>(views) - 1.0) * (1.0 - correlation);
      const double cost = -std::log10(std::max(min_probability, std::pow(1.0 - rate, looks)));
      missing.push_back({node_index(i), of_candidate, views, measured_views, cost});
    }
  }

  template <typename Scalar>
  double detection_rate(const SemanticNode<Scalar>& node) const {
    const auto known = detection_rates.find(node.label);
    return known != detection_rates.end() ? known->second : static_cast<double>(node.existence);
  }

  /// Whether the other graph has any object where this one should be: detectors rename and split.
  template <typename Scalar>
  bool found_by_another_name(const SemanticNode<Scalar>& node, const Eigen::Vector3d& position,
                             const TopologyGraph<Scalar>& other) const {
    const double reach = same_spot + same_spot_share * static_cast<double>(node.size.norm());
    return std::any_of(other.nodes().begin(), other.nodes().end(), [&](const auto& there) {
      return there.position && (there.position->template cast<double>() - position).norm() < reach;
    });
  }
};

}  // namespace v0
}  // namespace topobag
