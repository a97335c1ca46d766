// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/place_count.hpp>
#include <topobag/recognition/map_alignment.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/pose_with_covariance.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// What a verified match of a key frame of map b says of where that map lies in map a.
struct AlignmentVote {
  KeyframeId id{};  ///< of map b
  Eigen::Isometry3d T_b_camera = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_a_camera = Eigen::Isometry3d::Identity();  ///< by the match
  PoseWithCovariance<> T_a_b;
};

/// ξ with T = Exp(ξ), to the third order in the rotation.
inline Eigen::Matrix<double, 6, 1> logarithm(const Eigen::Isometry3d& T) {
  const Eigen::AngleAxisd turn(T.linear());
  const Eigen::Vector3d omega = turn.angle() * turn.axis(), t = T.translation();
  Eigen::Matrix<double, 6, 1> xi;
  xi << t - 0.5 * omega.cross(t) + omega.cross(omega.cross(t)) / 12.0, omega;
  return xi;
}

/// Whether an alignment puts the vote's camera where the vote's match did.
inline bool agrees(const PoseWithCovariance<>& T_a_b, const AlignmentVote& vote,
                   const AlignOptions& options) {
  const Eigen::Isometry3d T_a_camera = T_a_b.T * vote.T_b_camera;
  const Eigen::Isometry3d between = vote.T_a_camera.inverse() * T_a_camera;
  if (Eigen::AngleAxisd(between.linear()).angle() > options.recognition.place.distinct_rotation)
    return false;
  // A turn moves what is far from the match that told it.
  Eigen::Matrix<double, 3, 6> moved;
  moved.leftCols<3>().setIdentity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    moved.col(3 + i) = Eigen::Vector3d::Unit(i).cross(T_a_camera.translation());
  }
  const double variance = (moved * T_a_b.covariance * moved.transpose()).trace();
  return between.translation().norm() <=
         options.recognition.place.distinct_translation + options.deviations * std::sqrt(variance);
}

/// The votes that agree with an alignment.
inline std::vector<AlignmentVote> agreeing(const std::vector<AlignmentVote>& votes,
                                           const PoseWithCovariance<>& T_a_b,
                                           const AlignOptions& options) {
  std::vector<AlignmentVote> found;
  std::copy_if(votes.begin(), votes.end(), std::back_inserter(found),
               [&](const AlignmentVote& vote) { return agrees(T_a_b, vote, options); });
  return found;
}

/// Key frames among the votes.
inline std::size_t voters(const std::vector<AlignmentVote>& votes) {
  std::set<KeyframeId> ids;
  for (const AlignmentVote& vote : votes) ids.insert(vote.id);
  return ids.size();
}

/// Places of map b in which the voters stand.
inline std::size_t places_of_voters(const std::vector<AlignmentVote>& votes) {
  PlaceCount places;
  for (const AlignmentVote& vote : votes) {
    EntryInfo info;
    info.T_world_camera = vote.T_b_camera;
    places.add(vote.id, info);
  }
  return places.size();
}

/// The largest set of votes that agree with one of them. O(votes²).
inline std::vector<AlignmentVote> consensus(const std::vector<AlignmentVote>& votes,
                                            const AlignOptions& options) {
  std::vector<AlignmentVote> best;
  std::size_t most = 0;
  for (const AlignmentVote& vote : votes) {
    std::vector<AlignmentVote> found = agreeing(votes, vote.T_a_b, options);
    const std::size_t count = voters(found);
    if (count <= most) continue;
    most = count;
    best = std::move(found);
  }
  return best;
}

/// The most likely alignment of votes that agree, from one of them on, and its covariance: key
/// frames of one place see the same objects and count as one, and votes that differ by more than
/// they say make it wider. (Gauss–Newton on the poses.) Precondition: there are votes.
inline PoseWithCovariance<> mean_alignment(const std::vector<AlignmentVote>& votes) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  // About the middle of the cameras, where lever arms are short.
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const AlignmentVote& vote : votes) middle += vote.T_a_camera.translation();
  middle /= static_cast<double>(votes.size());
  const PoseWithCovariance<> T_middle_a{Eigen::Isometry3d(Eigen::Translation3d(-middle)),
                                        Matrix6::Zero()};
  Eigen::Isometry3d T = (T_middle_a * votes.front().T_a_b).T;
  Matrix6 covariance;
  double chi2 = 0.0;
  for (int iteration = 0; iteration < 10; ++iteration) {
    Matrix6 information = Matrix6::Zero();
    Vector6 pull = Vector6::Zero();
    chi2 = 0.0;
    for (const AlignmentVote& vote : votes) {
      const PoseWithCovariance<> T_middle_b = T_middle_a * vote.T_a_b;
      const Eigen::LLT<Matrix6> of_vote(T_middle_b.covariance);
      const Vector6 xi = logarithm(T_middle_b.T * T.inverse());
      information += of_vote.solve(Matrix6::Identity());
      pull += of_vote.solve(xi);
      chi2 += xi.dot(of_vote.solve(xi));
    }
    const Eigen::LLT<Matrix6> solver(information);
    covariance = solver.solve(Matrix6::Identity());
    const Vector6 step = solver.solve(pull);
    const Eigen::Vector3d turn = step.tail<3>();
    Eigen::Isometry3d move(Eigen::Translation3d(step.head<3>()));
    if (turn.norm() > 0.0) move.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
    T = move * T;
    if (step.norm() < 1e-9) break;
  }
  const double n = static_cast<double>(votes.size());
  const double scatter = n > 1.0 ? std::max(1.0, chi2 / (6.0 * (n - 1.0))) : 1.0;
  covariance *= scatter * n / static_cast<double>(places_of_voters(votes));
  return T_middle_a.inverse() * PoseWithCovariance<>{T, covariance};
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
