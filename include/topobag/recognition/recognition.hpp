// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/bag/place_contents.hpp>
#include <topobag/matching/refine_pose.hpp>
#include <topobag/matching/relative_pose.hpp>
#include <topobag/recognition/verdict.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// Another place of the map that fits about as well.
struct RivalPlace {
  KeyframeId id{};       ///< a key frame of it
  double support = 0.0;  ///< of its pose, by its graph, and by its place where that was asked
  double lead = 0.0;     ///< over it that was asked for
  /// Where it puts the query: in the key frame's camera frame, m.
  Eigen::Isometry3d T_candidate_query = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> T_world_query{};  ///< the same in the world, where the map knows
                                                     ///< the key frame's pose in it
};

/// What became of one candidate.
struct CandidateReport {
  KeyframeId id{};                          ///< of the entry
  double similarity = 0.0;                  ///< of the retrieval, in [0, 1]
  Verdict verdict = Verdict::no_agreement;  ///< how far it came
  /// The best one that will do, when enough objects agree: three, or two where both graphs know
  /// which way is down; one more where the scale is not known.
  std::optional<RelativePose> pose;
  std::vector<RelativePose> other_poses;  ///< the other distinct ones, best first
  ClassCounts matched;                    ///< matched objects by class (the query's)
  std::optional<double> place_support;    ///< of the pose by all objects of the place around it
  double place_share = 0.5;               ///< what that counts for beside the graph's own support
  std::optional<RefinedPose> place_pose;  ///< over those, when no fewer agree, and no less
  double place_scale = 1.0;               ///< of that pose, as `RelativePose::scale`
  double place_scale_deviation = 0.0;     ///< of that pose, as `RelativePose::scale_deviation`
  /// Of that pose, as `RelativePose::scale_covariance`.
  Eigen::Matrix<double, 6, 1> place_scale_covariance = Eigen::Matrix<double, 6, 1>::Zero();
  std::optional<RivalPlace> rival;  ///< that keeps the pose from being believed
  /// Where it passed by itself and was not judged by its place: the better candidate of its place
  /// whose verdict it shares, or else the best of all, elsewhere, which rivals it.
  std::optional<KeyframeId> judged_by;
  std::size_t places = 0;            ///< of the map that can hold what was matched
  bool with_views = true;            ///< of the query or the candidate, which the threshold goes by
  double threshold = 0.0;            ///< the score that was asked for, among these
  std::optional<double> confidence;  ///< P(true), when the decision is calibrated
  bool complete = true;              ///< false when the search ended with its budget

  /// What the objects say of the pose: by the candidate's graph alone, or, where the place around
  /// it was asked as well, their mean by `place_share`. Both are −log10 of the same odds, and err
  /// apart: one camera overlooks, a place holds what was there at another time. 0 without a pose.
  double support() const noexcept {
    if (!pose) return 0.0;
    if (!place_support) return pose->support();
    return (1.0 - place_share) * pose->support() + place_share * *place_support;
  }

  /// What the decision looks at: −log10 of the odds that chance made the match. 0 without a pose.
  double score() const noexcept { return pose ? support() + pose->viewpoint_odds : 0.0; }

  /// By how much the score passed the threshold; negative when it missed.
  double margin() const noexcept { return score() - threshold; }
};

/// The answer to "have I been here, and where exactly?", with the reasons.
struct Recognition {
  std::optional<CandidateReport> accepted;  ///< at most one; its pose is the `place_pose`, if any
  std::vector<CandidateReport> candidates;  ///< all that were tried: those whose place was asked,
                                            ///< then the others, each best score first
  /// The query graph has three nodes with a position (`TopologyGraph::is_matchable`).
  bool usable = false;
  std::size_t places = 0;  ///< of the map that were asked

  /// Whether a candidate was accepted.
  explicit operator bool() const noexcept { return accepted.has_value(); }
};

}  // namespace v0
}  // namespace topobag
