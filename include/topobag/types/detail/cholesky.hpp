// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The factor L of a covariance, Σ = L Lᵀ; its diagonal is not finite, or 0, where Σ is not
/// positive definite. In plain loops, here and below: Eigen's solvers take a compiler seconds, in
/// every file that includes them.
template <int Size>
Eigen::Matrix<double, Size, Size> cholesky(const Eigen::Matrix<double, Size, Size>& covariance) {
  Eigen::Matrix<double, Size, Size> L = Eigen::Matrix<double, Size, Size>::Zero();
  for (int row = 0; row < Size; ++row) {
    double diagonal = covariance(row, row);
    for (int column = 0; column < row; ++column) {
      double entry = covariance(row, column);
      for (int k = 0; k < column; ++k) entry -= L(row, k) * L(column, k);
      L(row, column) = entry / L(column, column);
      diagonal -= L(row, column) * L(row, column);
    }
    L(row, row) = std::sqrt(diagonal);
  }
  return L;
}

/// Σ⁻¹, as L⁻ᵀ L⁻¹; not finite where Σ is not positive definite.
template <int Size>
Eigen::Matrix<double, Size, Size> inverse_covariance(
    const Eigen::Matrix<double, Size, Size>& covariance) {
  const Eigen::Matrix<double, Size, Size> L = cholesky(covariance);
  Eigen::Matrix<double, Size, Size> whitening = Eigen::Matrix<double, Size, Size>::Zero();  // L⁻¹
  for (int column = 0; column < Size; ++column) {
    for (int row = column; row < Size; ++row) {
      double rest = row == column ? 1.0 : 0.0;
      for (int k = column; k < row; ++k) rest -= L(row, k) * whitening(k, column);
      whitening(row, column) = rest / L(row, row);
    }
  }
  Eigen::Matrix<double, Size, Size> inverse;
  for (int row = 0; row < Size; ++row) {
    for (int column = 0; column <= row; ++column) {
      double sum = 0.0;
      for (int k = row; k < Size; ++k) sum += whitening(k, row) * whitening(k, column);
      inverse(row, column) = inverse(column, row) = sum;
    }
  }
  return inverse;
}

/// ln of the root of Σ's determinant.
inline double log_root_determinant(const Eigen::Matrix<double, 6, 6>& covariance) {
  const Eigen::Matrix<double, 6, 6> L = cholesky(covariance);
  return std::log(L.diagonal().prod());
}

/// ξᵀ Σ⁻¹ ξ, as |L⁻¹ ξ|².
inline double squared_mahalanobis(const Eigen::Matrix<double, 6, 6>& covariance,
                                  const Eigen::Matrix<double, 6, 1>& xi) {
  const Eigen::Matrix<double, 6, 6> L = cholesky(covariance);
  Eigen::Matrix<double, 6, 1> whitened;
  double sum = 0.0;
  for (int row = 0; row < 6; ++row) {
    double rest = xi(row);
    for (int k = 0; k < row; ++k) rest -= L(row, k) * whitened(k);
    whitened(row) = rest / L(row, row);
    sum += whitened(row) * whitened(row);
  }
  return sum;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
