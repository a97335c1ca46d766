// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/missing_objects.hpp>
#include <topobag/types/pose_with_covariance.hpp>

namespace topobag {
inline namespace v0 {

/// The pose of a query graph in a candidate graph, and what stands behind it.
struct RelativePose {
  /// From the camera frame of the query graph's key frame, in the candidate's metres, to that of
  /// the candidate's.
  Eigen::Isometry3d T_candidate_query = Eigen::Isometry3d::Identity();

  /// Of the error ξ = (translation m, rotation rad) in the candidate's frame: T_true = Exp(ξ) ·
  /// T_candidate_query.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();

  std::vector<Correspondence> inliers;  ///< ascending query node
  double rms = 0.0;                     ///< of the inliers' residuals, m
  double spread = 0.0;                  ///< r.m.s. distance of the inliers from a line, m
  bool degenerate = true;               ///< near one line, or the rotation is not certain enough

  /// −log10 of the number of matches at least this good that chance would give
  /// (`chance_model.hpp`).
  double significance = 0.0;
  /// What `significance` loses to objects that should have been seen and were not
  /// (`missing_objects.hpp`).
  std::vector<MissingObject> missing;
  double missing_cost = 0.0;  ///< of the objects in `missing`
  /// log10 of the prior odds of the rotation (`viewpoint_prior.hpp`).
  double viewpoint_odds = 0.0;

  double scale = 1.0;            ///< candidate's metres in a unit of the query (`scale_range.hpp`)
  double scale_deviation = 0.0;  ///< of `scale`, one standard deviation; 0 where it was known
  /// Of ξ and the error λ of the scale's logarithm, scale_true = exp(λ) · scale: with `covariance`
  /// and the variance of λ, (scale_deviation / scale)², that of all seven unknowns.
  Eigen::Matrix<double, 6, 1> scale_covariance = Eigen::Matrix<double, 6, 1>::Zero();

  /// Where a point of the query's graph, in its own unit, is in the candidate's frame, m.
  template <typename Point>
  Eigen::Vector3d in_candidate(const Eigen::MatrixBase<Point>& query_point) const {
    return T_candidate_query * (scale * query_point.template cast<double>());
  }

  /// Standard deviation of the rotation about its least certain axis, rad.
  /// @tparam Solver  of the eigenvalues, with `computeDirect`
  template <typename Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>>
  double rotation_deviation() const {
    const Eigen::Matrix3d rotation = covariance.bottomRightCorner<3, 3>();
    Solver solver;
    solver.computeDirect(rotation, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, solver.eigenvalues()(2)));
  }

  /// The pose and its covariance as a type that says how they are to be read: for a factor between
  /// the two key frames, `as<GtsamPose>()` or `as<G2oPose>()`.
  PoseWithCovariance<> with_covariance() const { return {T_candidate_query, covariance}; }

  /// What the objects say; equal for the poses of a symmetric layout.
  double support() const noexcept { return significance - missing_cost; }

  /// What the decision looks at: −log10 of the odds that chance made the match.
  double score() const noexcept { return support() + viewpoint_odds; }
};

}  // namespace v0
}  // namespace topobag
