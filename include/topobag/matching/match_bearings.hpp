// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/bearing.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/bearing_options.hpp>
#include <topobag/matching/detail/bearing_judge.hpp>
#include <topobag/matching/detail/distinct_poses.hpp>
#include <topobag/matching/match_graphs.hpp>
#include <topobag/matching/match_options.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/matching/three_bearings.hpp>

namespace topobag {
inline namespace v0 {

/// Every distinct pose from which a graph's objects are seen in the directions of bearings.
struct BearingMatch {
  std::vector<RelativePose> poses;  ///< by falling score; empty when no four bearings agree
  std::size_t triples = 0;          ///< of pairs whose poses were tried
  bool complete = true;             ///< false when a budget ended first
};

namespace detail {

/// Works out poses for one candidate and one sighting.
template <typename Scalar>
class BearingSearch {
 public:
  BearingSearch(const TopologyGraph<Scalar>& candidate, const BearingSighting& query,
                const MatchOptions& options, const BearingOptions& bearing_options)
      : options_(options),
        bearing_options_(bearing_options),
        judge_(candidate, query, options, bearing_options) {}

  BearingMatch run() const {
    BearingMatch match;
    const auto hypotheses = try_triples(match);
    std::vector<typename BearingJudge<Scalar>::Settled> settled;
    for (const Hypothesis& hypothesis : hypotheses) {
      if (auto pose = judge_.settle(hypothesis.T, hypothesis.pairs, settled)) {
        settled.push_back(std::move(*pose));
      }
    }
    std::vector<RelativePose> poses;
    for (const auto& pose : settled) poses.push_back(judge_.weigh(pose));
    match.poses = distinct_poses(std::move(poses), options_);
    return match;
  }

 private:
  using Pairs = typename BearingJudge<Scalar>::Pairs;
  struct Hypothesis {
    Eigen::Isometry3d T;
    Pairs pairs;
    double deviation2;
  };

  /// The poses of all triples of pairs that may agree, of each set of supporters the closest; most
  /// supporters first.
  std::vector<Hypothesis> try_triples(BearingMatch& match) const {
    const auto& offered = judge_.offered();
    std::map<Pairs, Hypothesis> by_pairs;
    const auto agree = agreements();
    for (std::size_t i = 0; i < offered.size() && match.complete; ++i) {
      for (std::size_t j = i + 1; j < offered.size() && match.complete; ++j) {
        if (!agree[i][j]) continue;
        for (std::size_t k = j + 1; k < offered.size(); ++k) {
          if (!agree[i][k] || !agree[j][k]) continue;
          if (match.triples == bearing_options_.max_triples) {
            match.complete = false;
            break;
          }
          ++match.triples;
          offer_poses({i, j, k}, by_pairs);
        }
      }
    }
    std::vector<Hypothesis> hypotheses;
    for (auto& [pairs, hypothesis] : by_pairs) hypotheses.push_back(std::move(hypothesis));
    std::sort(hypotheses.begin(), hypotheses.end(), [](const Hypothesis& a, const Hypothesis& b) {
      return std::make_tuple(b.pairs.size(), a.deviation2, std::cref(a.pairs)) <
             std::make_tuple(a.pairs.size(), b.deviation2, std::cref(b.pairs));
    });
    if (hypotheses.size() > bearing_options_.max_hypotheses) {
      hypotheses.resize(bearing_options_.max_hypotheses);
      match.complete = false;
    }
    return hypotheses;
  }

  std::vector<std::vector<bool>> agreements() const {
    const auto& offered = judge_.offered();
    std::vector<std::vector<bool>> agree(offered.size(), std::vector<bool>(offered.size(), false));
    for (std::size_t i = 0; i < offered.size(); ++i) {
      for (std::size_t j = i + 1; j < offered.size(); ++j) {
        agree[i][j] = may_agree(offered[i], offered[j], options_.max_residual);
      }
    }
    return agree;
  }

  void offer_poses(const std::array<std::size_t, 3>& triple,
                   std::map<Pairs, Hypothesis>& by_pairs) const {
    const double wide = 2.0;  // times the gate: a pose of three bearings has all of their noise
    const auto& offered = judge_.offered();
    ThreeVectors points, bearings;
    for (std::size_t i = 0; i < 3; ++i) {
      points[i] = offered[triple[i]].target;
      bearings[i] = offered[triple[i]].direction;
    }
    const double deviations = wide * options_.inlier_deviations;
    const auto &first = offered[triple[0]], &third = offered[triple[2]];
    const RangeRatio ratio{third.nearest / first.farthest, third.farthest / first.nearest};
    for (const Eigen::Isometry3d& T : poses_from_three_bearings(points, bearings, ratio)) {
      if (!judge_.is_level(T, 2.0 * deviations)) continue;
      const bool in_range = std::all_of(triple.begin(), triple.end(), [&](std::size_t i) {
        const double range = (offered[i].target - T.translation()).norm();
        return range >= offered[i].nearest && range <= offered[i].farthest;
      });
      if (!in_range) continue;
      Pairs pairs = judge_.supporters_of(T, deviations);
      if (pairs.size() < judge_.min_pairs()) continue;
      const double deviation2 = judge_.squared_deviation(T, pairs);
      const auto [known, is_new] = by_pairs.try_emplace(pairs, Hypothesis{T, pairs, deviation2});
      if (!is_new && deviation2 < known->second.deviation2) {
        known->second.T = T;
        known->second.deviation2 = deviation2;
      }
    }
  }

  const MatchOptions& options_;
  const BearingOptions& bearing_options_;
  BearingJudge<Scalar> judge_;
};

}  // namespace detail

/// Matches the bearings of an image without depth with a graph's objects and works out every
/// distinct pose of its camera, best first.
///
/// Three pairs of an object and a bearing of its class propose up to four poses each (P3P; on
/// objects: Zins, Simon, Berger, OA-SLAM, ISMAR 2022); what the boxes' sizes tell of ranges, and
/// the vertical where both know it, leaves most of them out. Each pose gathers the bearings that
/// point at an object of their class, within the noise of both, is refined over them (Gauss–Newton)
/// and weighed: `BearingChance`, all ways to choose the pairs counted, whether they were tried or
/// not, what is missing, and the viewpoint's odds. Deterministic. O(triples · pairs).
template <typename Scalar>
BearingMatch match_bearings(const TopologyGraph<Scalar>& candidate, const BearingSighting& query,
                            const MatchOptions& options = {},
                            const BearingOptions& bearing_options = {}) {
  return detail::BearingSearch<Scalar>(candidate, query, options, bearing_options).run();
}

}  // namespace v0
}  // namespace topobag
