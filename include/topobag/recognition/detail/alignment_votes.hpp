// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/place_count.hpp>
#include <topobag/recognition/detail/alignment_motion.hpp>
#include <topobag/recognition/map_alignment.hpp>
#include <topobag/types/detail/cholesky.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// What a verified match of a key frame of map b says of where that map lies in map a.
/// @tparam Motion  `PoseWithCovariance<>`, or `Sim3WithCovariance` where b's unit is not known
template <typename Motion>
struct AlignmentVote {
  KeyframeId id{};                                               ///< of map b
  Eigen::Isometry3d T_b_camera = Eigen::Isometry3d::Identity();  ///< in b's unit
  Eigen::Isometry3d T_a_camera = Eigen::Isometry3d::Identity();  ///< by the match
  Motion a_b;
};

/// Whether an alignment puts the vote's camera where the vote's match did, and has its scale.
template <typename Motion>
bool agrees(const Motion& a_b, const AlignmentVote<Motion>& vote, const AlignOptions& options) {
  const double doubt = log_scale_variance(a_b) + log_scale_variance(vote.a_b);
  if (std::abs(std::log(scale_of(a_b) / scale_of(vote.a_b))) >
      options.deviations * std::sqrt(doubt))
    return false;
  const Eigen::Isometry3d T_a_camera = camera_in(a_b, vote.T_b_camera);
  const Eigen::Isometry3d between = vote.T_a_camera.inverse() * T_a_camera;
  if (Eigen::AngleAxisd(between.linear()).angle() > options.recognition.place.distinct_rotation)
    return false;
  // A turn moves what is far from the match that told it, and so does a scale.
  const auto moved = moved_by_error(a_b, T_a_camera.translation());
  const double variance = (moved * a_b.covariance * moved.transpose()).trace();
  return between.translation().norm() <=
         options.recognition.place.distinct_translation + options.deviations * std::sqrt(variance);
}

/// The votes that agree with an alignment.
template <typename Motion>
std::vector<AlignmentVote<Motion>> agreeing(const std::vector<AlignmentVote<Motion>>& votes,
                                            const Motion& a_b, const AlignOptions& options) {
  std::vector<AlignmentVote<Motion>> found;
  std::copy_if(votes.begin(), votes.end(), std::back_inserter(found),
               [&](const auto& vote) { return agrees(a_b, vote, options); });
  return found;
}

/// Key frames among the votes.
template <typename Motion>
std::size_t voters(const std::vector<AlignmentVote<Motion>>& votes) {
  std::set<KeyframeId> ids;
  for (const auto& vote : votes) ids.insert(vote.id);
  return ids.size();
}

/// Places of map b in which the voters stand.
/// @param scale  a's units in one of b's
template <typename Motion>
std::size_t places_of_voters(const std::vector<AlignmentVote<Motion>>& votes, double scale) {
  PlaceCount places;
  for (const auto& vote : votes) {
    EntryInfo info;
    info.T_world_camera = vote.T_b_camera;
    info.T_world_camera->translation() *= scale;
    places.add(vote.id, info);
  }
  return places.size();
}

/// An alignment about the middle of the cameras that told it, where lever arms are short.
template <typename Motion>
struct LikelyAlignment {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< in a
  Motion middle_b;                                   ///< covariance: by the votes' own doubt
  double chi2 = 0.0;                                 ///< of the votes

  /// The motion from b to a.
  Motion a_b() const {
    Motion a_middle;
    a_middle.T = Eigen::Translation3d(middle);
    return a_middle * middle_b;
  }
};

/// The most likely alignment of votes, from one of them on. (Gauss–Newton on the motions.)
/// Precondition: there are votes. O(votes).
template <typename Motion>
LikelyAlignment<Motion> likely_alignment(const std::vector<AlignmentVote<Motion>>& votes) {
  constexpr int unknowns = unknowns_v<Motion>;
  using Matrix = Eigen::Matrix<double, unknowns, unknowns>;
  using Vector = Eigen::Matrix<double, unknowns, 1>;
  LikelyAlignment<Motion> likely;
  for (const auto& vote : votes) likely.middle += vote.T_a_camera.translation();
  likely.middle /= static_cast<double>(votes.size());
  Motion middle_a;
  middle_a.T = Eigen::Translation3d(-likely.middle);
  Motion& mean = likely.middle_b;
  mean = middle_a * votes.front().a_b;
  for (int iteration = 0; iteration < 10; ++iteration) {
    Matrix information = Matrix::Zero();
    Vector pull = Vector::Zero();
    likely.chi2 = 0.0;
    for (const auto& vote : votes) {
      const Motion middle_b = middle_a * vote.a_b;
      const Matrix of_vote = inverse_covariance(middle_b.covariance);
      const Vector error = error_between(middle_b, mean), pulled = of_vote * error;
      information += of_vote;
      pull += pulled;
      likely.chi2 += error.dot(pulled);
    }
    mean.covariance = inverse_covariance(information);
    const Vector step = mean.covariance * pull;
    correct(mean, step);
    if (step.norm() < 1e-9) break;
  }
  return likely;
}

/// The same and its covariance: key frames of one place see the same objects and count as one, and
/// votes that differ by more than they say make it wider.
template <typename Motion>
Motion mean_alignment(const std::vector<AlignmentVote<Motion>>& votes) {
  LikelyAlignment<Motion> likely = likely_alignment(votes);
  const double n = static_cast<double>(votes.size());
  const double freedom = unknowns_v<Motion> * (n - 1.0);
  const double scatter = n > 1.0 ? std::max(1.0, likely.chi2 / freedom) : 1.0;
  const std::size_t places = places_of_voters(votes, scale_of(likely.middle_b));
  likely.middle_b.covariance *= scatter * n / static_cast<double>(places);
  return likely.a_b();
}

/// The largest set of votes that agree with one of them; where b's unit is not known, with what is
/// likely by all of them as well: a vote that hardly knows its scale agrees with nearly every
/// other, and these need not agree with each other. O(votes²).
template <typename Motion>
std::vector<AlignmentVote<Motion>> consensus(const std::vector<AlignmentVote<Motion>>& votes,
                                             const AlignOptions& options) {
  std::vector<AlignmentVote<Motion>> best;
  std::size_t most = 0;
  for (const auto& vote : votes) {
    std::vector<AlignmentVote<Motion>> found = agreeing(votes, vote.a_b, options);
    std::size_t count = voters(found);
    if constexpr (unknowns_v<Motion> == 7) {
      for (std::size_t before = 0; count > most && found.size() != before;) {
        before = found.size();
        found = agreeing(found, likely_alignment(found).a_b(), options);
        count = voters(found);
      }
    }
    if (count <= most) continue;
    most = count;
    best = std::move(found);
  }
  return best;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
