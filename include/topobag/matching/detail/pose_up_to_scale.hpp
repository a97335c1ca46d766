// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/graph/scaled_graph.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/detail/offered_pairs.hpp>
#include <topobag/matching/detail/pose_judge.hpp>
#include <topobag/matching/detail/scale_fit.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/matching/scale_range.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// `judge_pose` of graphs that are in one unit.
template <typename Scalar>
std::optional<RelativePose> judge_in_one_unit(const TopologyGraph<Scalar>& candidate,
                                              const TopologyGraph<Scalar>& query,
                                              const Eigen::Isometry3d& T_candidate_query,
                                              const MatchOptions& options) {
  const std::vector<Correspondence> pairs = offered_pairs(candidate, query, options.consistency);
  std::vector<PointPair> points;
  points.reserve(pairs.size());
  for (const Correspondence& pair : pairs) {
    points.push_back(point_pair(candidate.node(pair.candidate), query.node(pair.query),
                                options.consistency.noise));
  }
  const PoseJudge<Scalar> judge(candidate, query, pairs, points, options);
  auto supporters = judge.supporters_of(T_candidate_query);
  if (supporters.size() < judge.min_pairs()) return std::nullopt;
  const auto settled = judge.settle(T_candidate_query, std::move(supporters));
  if (!settled) return std::nullopt;
  return judge.weigh(*settled);
}

/// Refines a pose and the query's scale in turn, each over all objects that then agree, and weighs
/// what was found.
template <typename Scalar>
class ScaleJudge {
 public:
  /// Everything is referred to and has to stay. @param range  of `options`
  ScaleJudge(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
             const MatchOptions& options, const ScaleRange& range)
      : candidate_(candidate),
        query_(query),
        options_(options),
        range_(range),
        wide_(options),
        vertical_(shared_vertical(candidate, query)) {
    wide_.inlier_deviations *= wider;
  }

  /// One object more than a pose alone takes: as many as that fit some scale.
  std::size_t min_pairs() const noexcept { return vertical_ ? 3 : 4; }

  /// Nothing when too few objects agree, or at a scale out of range alone.
  std::optional<RelativePose> settle(Eigen::Isometry3d T_candidate_query, double scale) const {
    // A scale that is a little off puts the outer objects out of the gate, which alone tell of it.
    const MatchOptions* gate = &wide_;
    for (int round = 1;; ++round) {
      const TopologyGraph<Scalar> here = scaled(query_, scale);
      auto pose = judge_in_one_unit(candidate_, here, T_candidate_query, *gate);
      if (!pose || pose->inliers.size() < min_pairs()) return std::nullopt;
      std::vector<PointPair> points = points_of(*pose, here);
      const ScaleFit fit(pose->T_candidate_query, pose->covariance, points, options_.refine);
      const bool near = std::abs(fit.step) < small_step * std::sqrt(fit.variance);
      if (gate == &options_ && (near || round >= max_rounds)) {
        return finished(std::move(*pose), std::move(points), fit, scale);
      }
      if (near || round >= max_wide_rounds) gate = &options_;
      const double step = std::clamp(fit.step, -max_step, max_step);
      T_candidate_query = rescaled(pose->T_candidate_query, points, step);
      scale *= std::exp(step);
      if (!range_.contains(scale)) return std::nullopt;
    }
  }

 private:
  static constexpr int max_wide_rounds = 4;
  static constexpr int max_rounds = 8;
  static constexpr double wider = 1.5;       // than the gate
  static constexpr double small_step = 0.1;  // standard deviations
  static constexpr double max_step = 0.15;   // of the scale's logarithm

  std::vector<PointPair> points_of(const RelativePose& pose,
                                   const TopologyGraph<Scalar>& here) const {
    std::vector<PointPair> points;
    points.reserve(pose.inliers.size());
    for (const Correspondence& pair : pose.inliers) {
      points.push_back(point_pair(candidate_.node(pair.candidate), here.node(pair.query),
                                  options_.consistency.noise));
    }
    return points;
  }

  /// The pose that keeps the objects' middle where it is when the source grows.
  static Eigen::Isometry3d rescaled(Eigen::Isometry3d T, const std::vector<PointPair>& points,
                                    double log_scale) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const PointPair& pair : points) {
      middle += T.linear() * pair.source / static_cast<double>(points.size());
    }
    T.translation() -= std::expm1(log_scale) * middle;
    return T;
  }

  RelativePose finished(RelativePose pose, std::vector<PointPair> points, const ScaleFit& fit,
                        double scale) const {
    pose.scale = scale;
    pose.scale_deviation = scale * std::sqrt(fit.variance);
    pose.degenerate = pose.degenerate || std::sqrt(fit.variance) > range_.max_deviation;
    pose.scale_covariance = fit.variance * fit.lever;
    pose.covariance += fit.variance * fit.lever * fit.lever.transpose();
    // As the pose's own share of the significance, by the measurements alone.
    for (PointPair& pair : points) pair = pair.seen_alike();
    const Eigen::Isometry3d& T = pose.T_candidate_query;
    const auto covariance = pose_covariance(T, points, options_.refine, vertical_);
    const ScaleFit seen_alike(T, covariance, points, options_.refine);
    pose.significance -= ChanceModel::log10_scale_cost(range_, std::sqrt(seen_alike.variance));
    return pose;
  }

  const TopologyGraph<Scalar>& candidate_;
  const TopologyGraph<Scalar>& query_;
  const MatchOptions& options_;
  const ScaleRange& range_;
  MatchOptions wide_;
  std::optional<SharedVertical> vertical_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
