// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <topobag/assert.hpp>
#include <topobag/matching/detail/nearest_rotation.hpp>
#include <topobag/matching/shared_vertical.hpp>

namespace topobag {
inline namespace v0 {

/// A rigid motion between two point sets, and how well the points pin it down.
struct RigidFit {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();  ///< source to target
  double rms = 0.0;     ///< of the weighted residuals, m
  double spread = 0.0;  ///< of the source points about a line, m
};

/// R.m.s. distance of points (3 × n, double, m) from the line that fits them best, m; 0 =
/// collinear.
/// @param weights  n, positive; empty = all equal
template <typename Points>
double spread_about_line(const Eigen::MatrixBase<Points>& points,
                         const Eigen::VectorXd& weights = {}) {
  const auto weight = [&](Eigen::Index i) { return weights.size() == 0 ? 1.0 : weights(i); };
  double total = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    total += weight(i);
    mean += weight(i) * points.col(i);
  }
  mean /= total;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d centered = points.col(i) - mean;
    scatter += weight(i) / total * centered * centered.transpose();
  }
  // The two smaller principal variances are what a line leaves over.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> variances;
  variances.computeDirect(scatter, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, variances.eigenvalues()(0) + variances.eigenvalues()(1)));
}

namespace detail {

/// Weights of pairs of points, their sum, and the weighted means of both sides.
struct Centroids {
  /// @param weights  empty = all equal
  template <typename Target, typename Source>
  Centroids(const Target& target_points, const Source& source_points,
            const Eigen::VectorXd& weights)
      : weights_(weights) {
    for (Eigen::Index i = 0; i < source_points.cols(); ++i) {
      total += weight(i);
      target += weight(i) * target_points.col(i);
      source += weight(i) * source_points.col(i);
    }
    target /= total;
    source /= total;
  }

  double weight(Eigen::Index i) const { return weights_.size() == 0 ? 1.0 : weights_(i); }

  double total = 0.0;
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  Eigen::Vector3d source = Eigen::Vector3d::Zero();

 private:
  const Eigen::VectorXd& weights_;
};

/// `fit_rigid` without what says how well the points pin it down.
template <typename Target, typename Source>
Eigen::Isometry3d rigid_motion(const Target& target, const Source& source, const Centroids& mean) {
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < source.cols(); ++i) {
    correlation += mean.weight(i) / mean.total * (target.col(i) - mean.target) *
                   (source.col(i) - mean.source).transpose();
  }
  const Eigen::Matrix3d R = nearest_rotation(correlation);
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  T_target_source.linear() = R;
  T_target_source.translation() = mean.target - R * mean.source;
  return T_target_source;
}

}  // namespace detail

/// The rotation (det = +1) and translation that carry `source` onto `target` with the least
/// weighted squares: Umeyama, PAMI 1991, without scale; also Kabsch 1976.
///
/// @param target,source  matrices of double, 3 × n, m, column i of one belongs to column i of the
///                       other
/// @param weights        n, positive; empty = all equal
/// Nothing for n < 1. Of collinear points the rotation about their line is arbitrary: see `spread`.
/// O(n).
template <typename Target, typename Source>
std::optional<RigidFit> fit_rigid(const Eigen::MatrixBase<Target>& target,
                                  const Eigen::MatrixBase<Source>& source,
                                  const Eigen::VectorXd& weights = {}) {
  TOPOBAG_ASSERT(target.cols() == source.cols());
  TOPOBAG_ASSERT(weights.size() == 0 || weights.size() == source.cols());
  if (source.cols() < 1) return std::nullopt;
  const detail::Centroids mean(target, source, weights);
  RigidFit fit;
  fit.T_target_source = detail::rigid_motion(target, source, mean);
  double squares = 0.0;
  for (Eigen::Index i = 0; i < source.cols(); ++i) {
    const Eigen::Vector3d residual = target.col(i) - fit.T_target_source * source.col(i);
    squares += mean.weight(i) / mean.total * residual.squaredNorm();
  }
  fit.rms = std::sqrt(squares);
  fit.spread = spread_about_line(source, weights);
  return fit;
}

/// The same under a known vertical: yaw and translation alone. Nothing for n < 1; when all points
/// stand over each other the yaw is arbitrary. O(n).
template <typename Target, typename Source>
std::optional<RigidFit> fit_level(const Eigen::MatrixBase<Target>& target,
                                  const Eigen::MatrixBase<Source>& source,
                                  const SharedVertical& vertical,
                                  const Eigen::VectorXd& weights = {}) {
  if (source.cols() < 1) return std::nullopt;
  const detail::Centroids mean(target, source, weights);
  // Of the leveled source, turned by yaw about the upward axis u, Σ w t·s(yaw) is greatest.
  const Eigen::Matrix3d level = vertical.rotation(0.0);
  const Eigen::Vector3d up = -vertical.target_down;
  double along = 0.0, across = 0.0, squares = 0.0;
  for (Eigen::Index i = 0; i < source.cols(); ++i) {
    const Eigen::Vector3d t = target.col(i) - mean.target;
    const Eigen::Vector3d s = level * (source.col(i) - mean.source);
    const Eigen::Vector3d flat = s - up.dot(s) * up;
    along += mean.weight(i) * t.dot(flat);
    across += mean.weight(i) * t.dot(up.cross(flat));
    squares += mean.weight(i) * flat.squaredNorm();
  }
  RigidFit fit;
  fit.T_target_source.linear() = vertical.rotation(std::atan2(across, along));
  fit.T_target_source.translation() = mean.target - fit.T_target_source.linear() * mean.source;
  fit.spread = std::sqrt(squares / mean.total);
  double residuals = 0.0;
  for (Eigen::Index i = 0; i < source.cols(); ++i) {
    residuals +=
        mean.weight(i) * (target.col(i) - fit.T_target_source * source.col(i)).squaredNorm();
  }
  fit.rms = std::sqrt(residuals / mean.total);
  return fit;
}

}  // namespace v0
}  // namespace topobag
