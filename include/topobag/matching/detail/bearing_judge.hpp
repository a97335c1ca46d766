// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/graph/bearing.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/bearing_chance.hpp>
#include <topobag/matching/bearing_options.hpp>
#include <topobag/matching/detail/offered_bearings.hpp>
#include <topobag/matching/detail/one_to_one.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/ranged_bearings.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/matching/rigid_fit.hpp>
#include <topobag/matching/shared_vertical.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Fits poses to pairs of bearings and objects and says what stands behind them. Sets of pairs are
/// positions in `offered`, ascending.
template <typename Scalar>
class BearingJudge {
 public:
  using Pairs = std::vector<std::size_t>;

  /// A pose and the pairs that it brings together.
  struct Settled {
    Pairs pairs;
    RefinedPose pose;
  };

  /// Everything is referred to and has to stay.
  BearingJudge(const TopologyGraph<Scalar>& candidate, const BearingSighting& query,
               const MatchOptions& options, const BearingOptions& bearing_options)
      : candidate_(candidate),
        query_(query),
        options_(options),
        bearing_options_(bearing_options),
        offered_(offered_bearings(candidate, query.bearings, options.consistency.classes,
                                  options.consistency.noise, bearing_options)),
        all_at_one_metre_(ranged_bearings<Scalar>(query, 1.0)),
        vertical_(shared_vertical(candidate, all_at_one_metre_)) {}
  BearingJudge(const BearingJudge&) = delete;
  BearingJudge& operator=(const BearingJudge&) = delete;

  const std::vector<OfferedBearing>& offered() const noexcept { return offered_; }

  /// Three bearings give a pose, and a fourth, or the vertical, says whether it is one.
  std::size_t min_pairs() const noexcept { return vertical_ ? 3 : 4; }

  /// Whether the pose is as level as both frames say, within `deviations`.
  bool is_level(const Eigen::Isometry3d& T_candidate_query, double deviations) const {
    return !vertical_ || vertical_->tilt(T_candidate_query.linear()).squaredNorm() <=
                             deviations * deviations * vertical_->variance;
  }

  /// One-to-one pairs that the pose brings together within `deviations`, the closest first.
  Pairs supporters_of(const Eigen::Isometry3d& T_candidate_query, double deviations) const {
    const double least_cosine = std::cos(bearing_options_.max_angle);
    const Eigen::Isometry3d T_query_candidate = T_candidate_query.inverse();
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < offered_.size(); ++i) {
      const OfferedBearing& pair = offered_[i];
      const Eigen::Vector3d seen = T_query_candidate * pair.target;
      const double range = seen.norm();
      if (!(range >= pair.nearest && range <= pair.farthest)) continue;
      if (!(seen.dot(pair.direction) >= least_cosine * range)) continue;
      const double deviation2 = pair.at(T_candidate_query).squared_deviation(T_candidate_query);
      if (deviation2 <= deviations * deviations) near.emplace_back(deviation2, i);
    }
    std::sort(near.begin(), near.end());
    OneToOne unpaired(candidate_.size(), query_.bearings.size());
    Pairs supporters;
    for (const auto& [deviation2, i] : near) {
      if (unpaired.take(offered_[i].pair)) supporters.push_back(i);
    }
    std::sort(supporters.begin(), supporters.end());
    return supporters;
  }

  /// Sum of the pairs' squared deviations.
  double squared_deviation(const Eigen::Isometry3d& T_candidate_query, const Pairs& pairs) const {
    double sum = 0.0;
    for (const std::size_t i : pairs) {
      sum += offered_[i].at(T_candidate_query).squared_deviation(T_candidate_query);
    }
    return sum;
  }

  /// Refines a pose over `pairs`, then lets every pair that it brings together join, and refines
  /// over all of them. Nothing when too few remain, or those of a pose that is known.
  std::optional<Settled> settle(Eigen::Isometry3d T, Pairs pairs,
                                const std::vector<Settled>& known = {}) const {
    const int max_rounds = 4;
    for (int round = 1;; ++round) {
      T = refined(T, pairs);
      Pairs supporters = supporters_of(T, options_.inlier_deviations);
      if (supporters.size() < min_pairs()) return std::nullopt;
      const bool same = supporters == pairs;
      pairs = std::move(supporters);
      if (same || round == max_rounds) break;
    }
    const bool is_known = std::any_of(known.begin(), known.end(), [&](const Settled& other) {
      return other.pairs == pairs &&
             (other.pose.T_target_source.translation() - T.translation()).norm() < 0.05;  // m
    });
    if (is_known) return std::nullopt;
    const RefinedPose pose{T, pose_covariance(T, points_at(T, pairs), options_.refine, vertical_)};
    return Settled{std::move(pairs), pose};
  }

  /// Works out what is to be known of a pose.
  RelativePose weigh(const Settled& settled) const {
    const Eigen::Isometry3d& T = settled.pose.T_target_source;
    RelativePose pose;
    pose.T_candidate_query = T;
    pose.covariance = settled.pose.covariance;
    std::vector<BearingPair> seen;
    Eigen::Matrix3Xd targets(3, static_cast<Eigen::Index>(settled.pairs.size()));
    double squares = 0.0, other = 0.0, looks = 0.0;
    const std::map<ClassId, std::size_t> in_view = objects_in_view(T);
    const MatchOptions& options = options_;
    for (const std::size_t i : settled.pairs) {
      const OfferedBearing& pair = offered_[i];
      targets.col(static_cast<Eigen::Index>(seen.size())) = pair.target;
      pose.inliers.push_back(pair.pair);
      seen.push_back(bearing_pair(pair, T));
      seen.back().choices =
          choices(in_view, options.consistency.classes.group(node_of(pair).label));
      const PointPair points = pair.at(T);
      squares += points.residual(T).squaredNorm();
      const auto& node = node_of(pair);
      const Bearing& bearing = query_.bearings[value(pair.pair.query)];
      if (node.label != bearing.label) {
        other += options.chance.confusion
                     ? options.chance.confusion->cost(node.label, bearing.label)
                     : options.chance.relabeling;
      }
      looks += options.chance.appearance.log10_odds(node.appearance, bearing.appearance);
    }
    std::sort(pose.inliers.begin(), pose.inliers.end());
    pose.rms = std::sqrt(squares / static_cast<double>(seen.size()));
    pose.spread = spread_about_line(targets);
    const double shift = std::sqrt(pose.covariance.topLeftCorner<3, 3>().trace() / 3.0);
    pose.degenerate = pose.spread < options.min_spread ||
                      shift > bearing_options_.max_translation_deviation ||
                      pose.rotation_deviation() > options.max_rotation_deviation;
    pose.significance = bearing_options_.chance.log10_bayes_factor(
                            seen, unmatched(pose.inliers, in_view), settled.pose, vertical_) -
                        other;
    if (looks != 0.0) pose.significance += options.chance.appearance.log10_odds_together(looks);
    if (!std::isfinite(pose.significance)) {
      pose.significance = std::numeric_limits<double>::lowest();
    }
    pose.missing = options.missing.find(candidate_, ranged_bearings(query_, candidate_, pose),
                                        pose.inliers, T);
    for (const MissingObject& object : pose.missing) pose.missing_cost += object.cost;
    pose.viewpoint_odds = vertical_
                              ? options.viewpoint.log10_odds_of_yaw(vertical_->yaw(T.linear()))
                              : options.viewpoint.log10_odds(T.linear());
    return pose;
  }

 private:
  /// Objects of the candidate that the camera has in view, by group of classes; a group.
  std::map<ClassId, std::size_t> objects_in_view(const Eigen::Isometry3d& T_candidate_query) const {
    const ClassGroups& groups = options_.consistency.classes;
    const Eigen::Isometry3d T_query_candidate = T_candidate_query.inverse();
    const bool sized = query_.view.camera.width > 0 && query_.view.camera.height > 0;
    std::map<ClassId, std::size_t> counts;
    for (const auto& node : candidate_.nodes()) {
      if (!node.position) continue;
      const Eigen::Vector3d at = T_query_candidate * node.position->template cast<double>();
      if (!sized || query_.view.in_field(at, 0.0, bearing_options_.max_range)) {
        ++counts[groups.group(node.label)];
      }
    }
    return counts;
  }

  static std::size_t choices(const std::map<ClassId, std::size_t>& in_view, ClassId group) {
    const auto known = in_view.find(group);
    return known == in_view.end() ? 1 : known->second;
  }
  const auto& node_of(const OfferedBearing& pair) const {
    return candidate_.node(pair.pair.candidate);
  }

  /// Bearings in no pair of whose class there are objects in view.
  std::size_t unmatched(const std::vector<Correspondence>& pairs,
                        const std::map<ClassId, std::size_t>& in_view) const {
    std::vector<bool> matched(query_.bearings.size(), false);
    for (const Correspondence& pair : pairs) matched[value(pair.query)] = true;
    std::size_t count = 0;
    for (std::size_t i = 0; i < matched.size(); ++i) {
      const ClassId group = options_.consistency.classes.group(query_.bearings[i].label);
      if (!matched[i] && in_view.count(group) != 0) ++count;
    }
    return count;
  }

  std::vector<PointPair> points_at(const Eigen::Isometry3d& T, const Pairs& pairs) const {
    std::vector<PointPair> points;
    for (const std::size_t i : pairs) {
      points.push_back(offered_[i].sized_at(T, bearing_options_.chance.size_deviation));
    }
    return points;
  }

  /// Gauss–Newton over the bearings: each step by what they say of the pose there.
  Eigen::Isometry3d refined(Eigen::Isometry3d T, const Pairs& pairs) const {
    RefineOptions one_step = options_.refine;
    one_step.iterations = 1;
    for (int i = 0; i < options_.refine.iterations; ++i) {
      const Eigen::Isometry3d last = T;
      T = refined_motion(T, points_at(T, pairs), one_step, vertical_);
      const double moved =
          (T.translation() - last.translation()).norm() + (T.linear() - last.linear()).norm();
      if (moved < options_.refine.tolerance) break;
    }
    return T;
  }

  const TopologyGraph<Scalar>& candidate_;
  const BearingSighting& query_;
  const MatchOptions& options_;
  const BearingOptions& bearing_options_;
  std::vector<OfferedBearing> offered_;
  TopologyGraph<Scalar> all_at_one_metre_;
  std::optional<SharedVertical> vertical_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
