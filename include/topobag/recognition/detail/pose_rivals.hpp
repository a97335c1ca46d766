// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/recognition/decision_options.hpp>
#include <topobag/recognition/recognition.hpp>
#include <topobag/types/detail/cholesky.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Whether `pose` lies within the 95 % region of a pose that the matched objects leave open.
template <typename Pose>
bool within_uncertainty(const Pose& open, const Pose& pose) {
  const double chi2_95 = 12.5916;  // of six degrees of freedom
  const Eigen::Isometry3d between = pose.T_candidate_query * open.T_candidate_query.inverse();
  const Eigen::AngleAxisd turn(between.linear());
  Eigen::Matrix<double, 6, 1> xi;
  xi << between.translation(), turn.angle() * turn.axis();
  return squared_mahalanobis(open.covariance + pose.covariance, xi) <= chi2_95;
}

/// Matched objects of the query that another pose puts elsewhere, or leaves unmatched. All of them
/// where no frame is shared.
/// @param T_other_query_in_pose  the other pose, in the frame of `pose`'s candidate
template <typename Graph>
std::size_t objects_put_elsewhere(const Graph& query, const RelativePose& pose,
                                  const RelativePose& other,
                                  const std::optional<Eigen::Isometry3d>& T_other_query_in_pose) {
  const double same_spot = 0.3;  // m
  const auto elsewhere = [&](const Correspondence& pair) {
    const bool both = std::any_of(other.inliers.begin(), other.inliers.end(),
                                  [&](const auto& there) { return there.query == pair.query; });
    if (!both || !T_other_query_in_pose) return true;
    const Eigen::Vector3d at = query.node(pair.query).position->template cast<double>();
    return (pose.in_candidate(at) - *T_other_query_in_pose * (other.scale * at)).norm() > same_spot;
  };
  return static_cast<std::size_t>(
      std::count_if(pose.inliers.begin(), pose.inliers.end(), elsewhere));
}

/// By how many decades a pose has to lead over a rival that puts so many of its objects elsewhere.
/// As far as the rival is believable itself, the places are alike, and which of them is ahead is a
/// matter of noise: the residuals of n objects move −log10 of their likelihood by √(3n/2) / ln 10
/// (half a χ² with 3n degrees of freedom), two such by √2 times that.
inline double lead_to_ask(std::size_t objects_elsewhere, double rival_support,
                          const DecisionOptions& options) {
  const double believed = std::clamp(rival_support / options.rival_support, 0.0, 1.0);
  const double noise = std::sqrt(3.0 * static_cast<double>(objects_elsewhere)) / std::log(10.0);
  return options.min_lead + options.lead_deviations * believed * noise;
}

/// The same over another pose of the candidate itself.
template <typename Graph>
double lead_to_ask(const RelativePose& other, const RelativePose& pose, const Graph& query,
                   const DecisionOptions& options) {
  const std::size_t elsewhere = objects_put_elsewhere(query, pose, other, other.T_candidate_query);
  return lead_to_ask(elsewhere, other.support(), options);
}

/// Whether another pose of the candidate keeps `pose` from being believed: it fits about as well. A
/// degenerate pose is no answer itself, but says that the answer is elsewhere if it fits better and
/// does not leave `pose` open.
template <typename Graph>
bool is_rival(const RelativePose& other, const RelativePose& pose, const Graph& query,
              const DecisionOptions& options) {
  if (other.degenerate) return other.score() > pose.score() && !within_uncertainty(other, pose);
  return other.support() > pose.support() - lead_to_ask(other, pose, query, options);
}

/// The place of a hypothesis, which fits about as well as the pose of another one.
/// @param id    of the hypothesis' candidate
/// @param lead  over it that is asked for
template <typename Hypothesis>
RivalPlace rival_place(KeyframeId id, const Hypothesis& hypothesis, double lead) {
  RivalPlace rival{id, hypothesis.support, lead, hypothesis.pose->T_candidate_query};
  if (hypothesis.info && hypothesis.info->T_world_camera) {
    rival.T_world_query = *hypothesis.info->T_world_camera * rival.T_candidate_query;
  }
  return rival;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
