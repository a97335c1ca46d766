// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/correspondence.hpp>

namespace topobag {
inline namespace v0 {

/// Negative evidence: objects of one graph that the other's cameras should have seen, and did not.
struct MissingObjects {
  double weight = 1.0;
  double max_detection_rate = 0.8;  ///< of one view; even a plain object is overlooked now and then
  double correlation = 0.5;
  double min_probability =
      0.1;  ///< that an object is missing for another reason: moved, hidden, renamed
  double image_margin = 40.0;  ///< px
  double max_depth = 5.0;      ///< m

  /// Sum over the missing objects of −log10 P(missing | same place).
  template <typename Scalar>
  double penalty(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                 const std::vector<Correspondence>& inliers,
                 const Eigen::Isometry3d& T_candidate_query) const {
    std::vector<bool> candidate_matched(candidate.size(), false),
        query_matched(query.size(), false);
    for (const Correspondence& pair : inliers) {
      candidate_matched[value(pair.candidate)] = true;
      query_matched[value(pair.query)] = true;
    }
    return weight * (one_way(candidate, candidate_matched, query, T_candidate_query.inverse()) +
                     one_way(query, query_matched, candidate, T_candidate_query));
  }

 private:
  template <typename Scalar>
  double one_way(const TopologyGraph<Scalar>& from, const std::vector<bool>& matched,
                 const TopologyGraph<Scalar>& to, const Eigen::Isometry3d& T_to_from) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const auto& node = from.nodes()[i];
      if (matched[i] || !node.position) continue;
      const Eigen::Vector3d position = T_to_from * node.position->template cast<double>();
      std::size_t views = 0;
      for (const auto& view : to.views()) {
        if (view.should_show(position.template cast<Scalar>(), static_cast<Scalar>(image_margin),
                             static_cast<Scalar>(max_depth)))
          ++views;
      }
      if (views == 0) continue;
      const double rate = std::min(max_detection_rate, static_cast<double>(node.existence));
      const double looks = 1.0 + (static_cast<double>(views) - 1.0) * (1.0 - correlation);
      sum -= std::log10(std::max(min_probability, std::pow(1.0 - rate, looks)));
    }
    return sum;
  }
};

}  // namespace v0
}  // namespace topobag
