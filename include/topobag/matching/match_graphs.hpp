// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/chance_model.hpp>
#include <topobag/matching/consistency_graph.hpp>
#include <topobag/matching/detail/clique_search.hpp>
#include <topobag/matching/detail/one_to_one.hpp>
#include <topobag/matching/detail/point_sets.hpp>
#include <topobag/matching/match_nodes.hpp>
#include <topobag/matching/missing_objects.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/refine_pose.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/matching/rigid_fit.hpp>
#include <topobag/matching/viewpoint_prior.hpp>

namespace topobag {
inline namespace v0 {

/// How poses are found and scored.
struct MatchOptions {
  ConsistencyOptions consistency{};  ///< which pairs of nodes agree
  ChanceModel chance{};              ///< how often chance does as well
  MissingObjects missing{};          ///< what absent objects cost
  ViewpointPrior viewpoint{};        ///< how likely a revisit is turned so
  RefineOptions refine{};            ///< the fit over all objects
  std::size_t max_steps = 20000;     ///< branches of the clique search
  std::size_t slack = 1;  ///< cliques this much smaller than the largest are tried as well
  std::size_t max_hypotheses =
      64;  ///< cliques whose pose is worked out, largest and tightest first
  double inlier_deviations =
      3.0;  ///< standard deviations (of a 3-D residual) within which a pair supports a pose
  double max_residual = 0.40;  ///< m; beyond it a pair supports no pose
  double min_spread = 0.05;    ///< m; inliers nearer to one line leave the rotation about it open
  double max_rotation_deviation =
      0.31;  ///< rad; a pose less certain about its worst axis is degenerate
  double distinct_translation = 0.5;  ///< m; two poses further apart,
  double distinct_rotation = 0.5;     ///< rad; or turned by more, are different
};

/// Every distinct pose under which the query graph fits the candidate graph.
struct GraphMatch {
  std::vector<RelativePose> poses;  ///< by falling score; empty when no three nodes agree
  bool complete = true;             ///< false when a budget ended first
};

namespace detail {

/// Works out poses for one candidate and one query graph.
template <typename Scalar>
class PoseSearch {
 public:
  PoseSearch(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
             const MatchOptions& options)
      : candidate_(candidate),
        query_(query),
        options_(options),
        graph_(candidate, query, options.consistency) {}

  GraphMatch run() const {
    GraphMatch match;
    CliqueSearch search(graph_.agreement(), graph_.query_of());
    std::vector<std::pair<double, std::vector<std::size_t>>> hypotheses;  // rms difference, clique
    std::size_t largest = 0;
    const std::size_t steps = search.run(
        3, options_.slack, options_.max_steps, [&](const std::vector<std::size_t>& clique) {
          largest = std::max(largest, clique.size());
          hypotheses.emplace_back(rms_distance_difference(graph_, clique), clique);
        });
    match.complete = graph_.complete() && steps < options_.max_steps;
    std::sort(hypotheses.begin(), hypotheses.end(), [](const auto& a, const auto& b) {
      return std::make_tuple(b.second.size(), a.first, std::cref(a.second)) <
             std::make_tuple(a.second.size(), b.first, std::cref(b.second));
    });
    // Those that are large enough come first.
    const auto worth =
        std::partition_point(hypotheses.begin(), hypotheses.end(), [&](const auto& hypothesis) {
          return hypothesis.second.size() + options_.slack >= largest;
        });
    hypotheses.erase(worth, hypotheses.end());
    if (hypotheses.size() > options_.max_hypotheses) {
      hypotheses.resize(options_.max_hypotheses);
      match.complete = false;
    }

    std::vector<Settled> settled;
    for (const auto& [rms, clique] : hypotheses) {
      if (auto pose = settle(clique, settled)) settled.push_back(std::move(*pose));
    }
    std::vector<RelativePose> poses;
    poses.reserve(settled.size());
    for (const Settled& pose : settled) poses.push_back(weigh(pose));
    // Positions are sorted, not poses: stable_sort's buffer is not aligned for AVX's matrices.
    std::vector<std::size_t> best_first(poses.size());
    std::iota(best_first.begin(), best_first.end(), std::size_t{0});
    std::stable_sort(best_first.begin(), best_first.end(), [&](std::size_t a, std::size_t b) {
      return poses[a].score() > poses[b].score();
    });
    for (const std::size_t i : best_first) {
      const bool seen =
          std::any_of(match.poses.begin(), match.poses.end(),
                      [&](const RelativePose& better) { return stands_for(better, poses[i]); });
      if (!seen) match.poses.push_back(std::move(poses[i]));
    }
    return match;
  }

 private:
  /// A pose and the pairs that it brings together: positions in the consistency graph, ascending.
  struct Settled {
    std::vector<std::size_t> pairs;
    RefinedPose pose;
  };

  std::vector<PointPair> points_of(const std::vector<std::size_t>& pairs) const {
    std::vector<PointPair> points;
    points.reserve(pairs.size());
    for (const std::size_t i : pairs) points.push_back(graph_.points()[i]);
    return points;
  }

  /// Fits the clique, then lets every pair that the pose brings together join, and refines over all
  /// of them. Nothing when fewer than three remain, or those of a pose that is known: most cliques
  /// are parts of the same few sets.
  std::optional<Settled> settle(const std::vector<std::size_t>& clique,
                                const std::vector<Settled>& known) const {
    std::vector<std::size_t> pairs = clique;
    std::vector<PointPair> points = points_of(pairs);
    const PointSets sets(points);
    Eigen::Isometry3d T_candidate_query =
        fit_rigid(sets.target, sets.source, sets.weights)->T_target_source;
    for (int round = 1;; ++round) {
      T_candidate_query = refined_motion(T_candidate_query, points, options_.refine);
      std::vector<std::size_t> supporters = supporters_of(T_candidate_query);
      const bool is_known = std::any_of(known.begin(), known.end(), [&](const Settled& other) {
        return other.pairs == supporters;
      });
      if (supporters.size() < 3 || is_known) return std::nullopt;
      const bool same = supporters == pairs;
      pairs = std::move(supporters);
      points = points_of(pairs);
      if (same || round == max_rounds) break;
    }
    return Settled{
        std::move(pairs),
        {T_candidate_query, pose_covariance(T_candidate_query, points, options_.refine)}};
  }

  /// Works out what is to be known of a pose.
  RelativePose weigh(const Settled& settled) const {
    const std::vector<PointPair> points = points_of(settled.pairs);
    RelativePose pose;
    pose.inliers = pairs_of(graph_, settled.pairs);
    pose.T_candidate_query = settled.pose.T_target_source;
    pose.covariance = settled.pose.covariance;
    double squares = 0.0;
    for (const PointPair& pair : points) {
      squares += pair.residual(pose.T_candidate_query).squaredNorm();
    }
    pose.rms = std::sqrt(squares / static_cast<double>(points.size()));
    const PointSets sets(points);
    pose.spread = spread_about_line(sets.source, sets.weights);
    pose.degenerate = pose.spread < options_.min_spread ||
                      pose.rotation_deviation() > options_.max_rotation_deviation;
    pose.significance = options_.chance.significance(candidate_, query_, pose.inliers, points,
                                                     settled.pose, options_.consistency.classes);
    pose.missing = options_.missing.find(candidate_, query_, pose.inliers, pose.T_candidate_query);
    for (const MissingObject& object : pose.missing) pose.missing_cost += object.cost;
    pose.viewpoint_odds = options_.viewpoint.log10_odds(pose.T_candidate_query.linear());
    return pose;
  }

  /// One-to-one pairs that the pose brings together, the closest (in standard deviations) first.
  std::vector<std::size_t> supporters_of(const Eigen::Isometry3d& T_candidate_query) const {
    const double max_residual2 = options_.max_residual * options_.max_residual;
    const double max_deviation2 = options_.inlier_deviations * options_.inlier_deviations;
    std::vector<std::pair<double, std::size_t>> near;
    near.reserve(graph_.points().size());
    for (std::size_t i = 0; i < graph_.points().size(); ++i) {
      const PointPair& points = graph_.points()[i];
      if (points.residual(T_candidate_query).squaredNorm() > max_residual2) continue;
      const double deviation2 = points.squared_deviation(T_candidate_query);
      if (deviation2 <= max_deviation2) near.emplace_back(deviation2, i);
    }
    std::sort(near.begin(), near.end());
    OneToOne unpaired(candidate_.size(), query_.size());
    std::vector<std::size_t> supporters;
    supporters.reserve(near.size());
    for (const auto& [deviation2, i] : near) {
      if (unpaired.take(graph_.pairs()[i])) supporters.push_back(i);
    }
    std::sort(supporters.begin(), supporters.end());
    return supporters;
  }

  /// Whether a pose need not be told beside a better one: they are the same, and the better one is
  /// no less determined.
  bool stands_for(const RelativePose& better, const RelativePose& pose) const {
    if (better.degenerate && !pose.degenerate) return false;
    const Eigen::Isometry3d between = better.T_candidate_query.inverse() * pose.T_candidate_query;
    return between.translation().norm() <= options_.distinct_translation &&
           Eigen::AngleAxisd(between.linear()).angle() <= options_.distinct_rotation;
  }

  static constexpr int max_rounds = 3;  // inliers rarely change after the second

  const TopologyGraph<Scalar>& candidate_;
  const TopologyGraph<Scalar>& query_;
  const MatchOptions& options_;
  ConsistencyGraph graph_;
};

}  // namespace detail

/// Matches two graphs and works out every distinct pose between them, best first.
///
/// Large sets of consistent pairs (`match_nodes`) propose poses; each gathers the pairs that it
/// brings together, is refined over them, and is weighed against chance and against what should
/// have been seen. Mirror images fall out in the rigid fit. Deterministic. Cost: that of
/// `match_nodes` and a few microseconds a hypothesis.
template <typename Scalar>
GraphMatch match_graphs(const TopologyGraph<Scalar>& candidate, const TopologyGraph<Scalar>& query,
                        const MatchOptions& options = {}) {
  return detail::PoseSearch<Scalar>(candidate, query, options).run();
}

}  // namespace v0
}  // namespace topobag
