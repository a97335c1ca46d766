// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The rotation R (det = +1) for which trace(Rᵀ C) is greatest, arbitrary about an axis that C
/// leaves open.
///
/// By the singular vectors of C. Of points that lie along no line the two greater ones follow from
/// the eigenvectors of CᵀC in closed form, the third one is square to them, and what rounding has
/// turned is turned back: as exact as a decomposition, which the others get, in a third of its
/// time.
template <typename Derived>
Eigen::Matrix3d nearest_rotation(const Eigen::MatrixBase<Derived>& C) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> squared;
  squared.computeDirect(C.transpose() * C);
  if (squared.eigenvalues()(1) > 1e-6 * squared.eigenvalues()(2)) {
    Eigen::Matrix3d target, source;
    source.col(0) = squared.eigenvectors().col(2);
    source.col(1) = squared.eigenvectors().col(1);
    source.col(2) = source.col(0).cross(source.col(1));
    target.col(0) = (C * source.col(0)).normalized();
    target.col(2) = target.col(0).cross(C * source.col(1)).normalized();
    target.col(1) = target.col(2).cross(target.col(0));
    const Eigen::Matrix3d R = target * source.transpose();
    // A Newton step of the trace: Rᵀ C is symmetric at its greatest.
    const Eigen::Matrix3d left = R.transpose() * C;
    const Eigen::Vector3d skew(left(2, 1) - left(1, 2), left(0, 2) - left(2, 0),
                               left(1, 0) - left(0, 1));
    const Eigen::Matrix3d bend =
        left.trace() * Eigen::Matrix3d::Identity() - 0.5 * (left + left.transpose());
    const Eigen::Vector3d half_turn = 0.5 * (bend.inverse() * skew);
    const Eigen::Quaterniond turn(1.0, half_turn.x(), half_turn.y(), half_turn.z());
    return R * turn.normalized().toRotationMatrix();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(C, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) signs.z() = -1.0;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
