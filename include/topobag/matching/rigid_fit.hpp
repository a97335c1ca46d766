// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <topobag/assert.hpp>

namespace topobag {
inline namespace v0 {

/// A rigid motion between two point sets, and how well the points pin it down.
struct RigidFit {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  double rms = 0.0;     ///< of the weighted residuals, m
  double spread = 0.0;  ///< r.m.s. distance of the source points from the line that fits them best,
                        ///< m; 0 = collinear
};

/// The rotation (det = +1) and translation that carry `source` onto `target` with the least
/// weighted squares: Umeyama, PAMI 1991, without scale; also Kabsch 1976.
///
/// @param target,source  3 × n, m, column i of one belongs to column i of the other
/// @param weights        n, positive; empty = all equal
/// Nothing for n < 1. Of collinear points the rotation about their line is arbitrary: see `spread`.
/// O(n).
inline std::optional<RigidFit> fit_rigid(const Eigen::Matrix3Xd& target,
                                         const Eigen::Matrix3Xd& source,
                                         const Eigen::VectorXd& weights = {}) {
  TOPOBAG_ASSERT(target.cols() == source.cols());
  TOPOBAG_ASSERT(weights.size() == 0 || weights.size() == source.cols());
  if (source.cols() < 1) return std::nullopt;
  Eigen::RowVectorXd share = weights.size() == 0
                                 ? Eigen::RowVectorXd(Eigen::RowVectorXd::Ones(source.cols()))
                                 : Eigen::RowVectorXd(weights.transpose());
  share /= share.sum();
  const Eigen::Vector3d target_mean = target * share.transpose();
  const Eigen::Vector3d source_mean = source * share.transpose();
  const Eigen::Matrix3Xd target_centered = target.colwise() - target_mean;
  const Eigen::Matrix3Xd source_centered = source.colwise() - source_mean;
  const Eigen::Matrix3Xd source_weighted = source_centered.array().rowwise() * share.array();

  const Eigen::Matrix3d correlation = target_centered * source_weighted.transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) signs.z() = -1.0;

  RigidFit fit;
  const Eigen::Matrix3d R = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  fit.T_target_source.linear() = R;
  fit.T_target_source.translation() = target_mean - R * source_mean;
  fit.rms = std::sqrt((target_centered - R * source_centered).colwise().squaredNorm().dot(share));
  // Singular values of the centred points: the two smaller ones are what a line leaves over.
  const Eigen::Matrix3d scatter = source_centered * source_weighted.transpose();
  const Eigen::Vector3d spreads = Eigen::JacobiSVD<Eigen::Matrix3d>(scatter).singularValues();
  fit.spread = std::sqrt(spreads(1) + spreads(2));
  return fit;
}

}  // namespace v0
}  // namespace topobag
