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

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/detail/chosen_pairs.hpp>
#include <topobag/matching/detail/one_to_one.hpp>
#include <topobag/matching/detail/point_sets.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/matching/rigid_fit.hpp>
#include <topobag/matching/shared_vertical.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Fits poses to pairs of nodes and says what stands behind them. Sets of pairs are positions in
/// `pairs`, ascending.
template <typename Scalar>
class PoseJudge {
 public:
  using Pairs = std::vector<std::size_t>;

  /// A pose and the pairs that it brings together.
  struct Settled {
    Pairs pairs;
    RefinedPose pose;
  };

  /// @param pairs   all that are offered
  /// @param points  their positions, parallel
  /// Everything is referred to and has to stay.
  PoseJudge(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
            const std::vector<Correspondence>& pairs, const std::vector<PointPair>& points,
            const MatchOptions& options)
      : candidate_(candidate),
        query_(query),
        pairs_(pairs),
        points_(points),
        options_(options),
        vertical_(shared_vertical(candidate, query)) {
    const double max_residual2 = options.max_residual * options.max_residual;
    const double max_deviation2 = options.inlier_deviations * options.inlier_deviations;
    reach2_.reserve(points.size());
    for (const PointPair& pair : points) {
      reach2_.push_back(std::min(max_residual2, max_deviation2 * pair.max_variance()));
    }
  }

  /// Where the vertical is known, two objects that do not stand over each other give a pose.
  std::size_t min_pairs() const noexcept { return vertical_ ? 2 : 3; }

  /// What a set of agreeing pairs proposes: the pose that fits them, all pairs that it brings
  /// together, and what these are worth before they have a say in the pose.
  struct Proposal {
    Pairs pairs;
    Eigen::Isometry3d T_candidate_query;
    double significance;
  };

  /// Nothing when too few come together, or those of a proposal that is known: most cliques are
  /// parts of the same few sets.
  std::optional<Proposal> propose(const Pairs& clique, const std::vector<Proposal>& known) const {
    const Eigen::Isometry3d T = fitted(clique);
    Pairs supporters = supporters_of(T);
    if (supporters.size() < min_pairs() || is_among(known, supporters)) return std::nullopt;
    const double significance = significance_of(T, correspondences(supporters), supporters);
    return Proposal{std::move(supporters), T, significance};
  }

  /// Refines a pose over `pairs`, then lets every pair that it brings together join, and refines
  /// over all of them. Nothing when too few remain, or those of a pose that is known.
  std::optional<Settled> settle(Eigen::Isometry3d T_candidate_query, Pairs pairs,
                                const std::vector<Settled>& known = {}) const {
    for (int round = 1;; ++round) {
      T_candidate_query =
          refined_motion(T_candidate_query, chosen(pairs), options_.refine, vertical_);
      Pairs supporters = supporters_of(T_candidate_query);
      if (supporters.size() < min_pairs() || is_among(known, supporters)) return std::nullopt;
      const bool same = supporters == pairs;
      pairs = std::move(supporters);
      if (same || round == max_rounds) break;
    }
    const auto covariance =
        pose_covariance(T_candidate_query, chosen(pairs), options_.refine, vertical_);
    return Settled{std::move(pairs), {T_candidate_query, covariance}};
  }

  /// Works out what is to be known of a pose.
  RelativePose weigh(const Settled& settled) const {
    const ChosenPairs<> points = chosen(settled.pairs);
    RelativePose pose;
    pose.inliers = correspondences(settled.pairs);
    pose.T_candidate_query = settled.pose.T_target_source;
    pose.covariance = settled.pose.covariance;
    double squares = 0.0;
    for (const PointPair& pair : points) {
      squares += pair.residual(pose.T_candidate_query).squaredNorm();
    }
    pose.rms = std::sqrt(squares / static_cast<double>(points.size()));
    const PointSets sets(points);
    pose.spread = vertical_ ? fit_level(sets.target, sets.source, *vertical_, sets.weights)->spread
                            : spread_about_line(sets.source, sets.weights);
    pose.degenerate = pose.spread < options_.min_spread ||
                      pose.rotation_deviation() > options_.max_rotation_deviation;
    pose.significance = significance_of(pose.T_candidate_query, pose.inliers, settled.pairs);
    pose.missing = options_.missing.find(candidate_, query_, pose.inliers, pose.T_candidate_query);
    for (const MissingObject& object : pose.missing) pose.missing_cost += object.cost;
    const auto R = pose.T_candidate_query.linear();
    pose.viewpoint_odds = vertical_ ? options_.viewpoint.log10_odds_of_yaw(vertical_->yaw(R))
                                    : options_.viewpoint.log10_odds(R);
    return pose;
  }

  /// One-to-one pairs that the pose brings together, the closest (in standard deviations) first.
  Pairs supporters_of(const Eigen::Isometry3d& T_candidate_query) const {
    const double max_deviation2 = options_.inlier_deviations * options_.inlier_deviations;
    std::vector<std::pair<double, std::size_t>> near;
    near.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (points_[i].residual(T_candidate_query).squaredNorm() > reach2_[i]) continue;
      const double deviation2 = points_[i].squared_deviation(T_candidate_query);
      if (deviation2 <= max_deviation2) near.emplace_back(deviation2, i);
    }
    std::sort(near.begin(), near.end());
    OneToOne unpaired(candidate_.size(), query_.size());
    Pairs supporters;
    supporters.reserve(near.size());
    for (const auto& [deviation2, i] : near) {
      if (unpaired.take(pairs_[i])) supporters.push_back(i);
    }
    std::sort(supporters.begin(), supporters.end());
    return supporters;
  }

 private:
  /// The rigid motion that fits these pairs best.
  Eigen::Isometry3d fitted(const Pairs& pairs) const {
    const PointSets sets(chosen(pairs));
    if (vertical_)
      return fit_level(sets.target, sets.source, *vertical_, sets.weights)->T_target_source;
    return rigid_motion(sets.target, sets.source,
                        Centroids(sets.target, sets.source, sets.weights));
  }

  /// The poses of a symmetric layout turn the view in different ways and shall be supported alike:
  /// so all is seen from one side.
  double significance_of(const Eigen::Isometry3d& T_candidate_query,
                         const std::vector<Correspondence>& inliers, const Pairs& pairs) const {
    const ChosenPairs<true> points(points_, pairs);
    const RefinedPose seen_alike{
        T_candidate_query, pose_covariance(T_candidate_query, points, options_.refine, vertical_)};
    return options_.chance.significance(candidate_, query_, inliers, points, seen_alike,
                                        options_.consistency.classes, vertical_);
  }

  template <typename Known>
  static bool is_among(const std::vector<Known>& known, const Pairs& pairs) {
    return std::any_of(known.begin(), known.end(),
                       [&](const Known& other) { return other.pairs == pairs; });
  }

  std::vector<Correspondence> correspondences(const Pairs& pairs) const {
    std::vector<Correspondence> chosen;
    chosen.reserve(pairs.size());
    for (const std::size_t i : pairs) chosen.push_back(pairs_[i]);
    return chosen;
  }

  ChosenPairs<> chosen(const Pairs& pairs) const { return {points_, pairs}; }

  static constexpr int max_rounds = 3;  // inliers rarely change after the second

  const TopologyGraph<Scalar>& candidate_;
  const TopologyGraph<Scalar>& query_;
  const std::vector<Correspondence>& pairs_;
  const std::vector<PointPair>& points_;
  const MatchOptions& options_;
  std::optional<SharedVertical> vertical_;
  std::vector<double> reach2_;  ///< m², squared residual beyond which a pair supports no pose
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
