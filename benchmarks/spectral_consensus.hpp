// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include <Eigen/Core>

/// The set of pairs that agree best by a spectral relaxation, in the manner of CLIPPER (P. Lusk,
/// K. Fathian, J. How, "CLIPPER: a graph-theoretic framework for robust data association", 2021):
/// the non-negative unit vector u that maximises uᵀ(M − dC)u, where C has a one for every two pairs
/// that contradict each other, is followed while d grows from nothing until no two pairs with a
/// share in u contradict each other; the pairs are then taken by falling share. Ours, and plain:
/// projected power steps on a shifted matrix. O(iterations · pairs²).
/// @param affinity  M: symmetric, with ones on the diagonal and zeros where pairs contradict
/// @return          indices of pairs without a contradiction, ascending
inline std::vector<std::size_t> spectral_consensus(const Eigen::MatrixXd& affinity) {
  const Eigen::Index count = affinity.rows();
  if (count == 0) return {};
  const Eigen::MatrixXd contradiction = (affinity.array() == 0.0).cast<double>();
  constexpr double least_share = 1e-4, still = 1e-6;
  Eigen::VectorXd u = affinity * Eigen::VectorXd::Ones(count);
  u.normalize();
  for (double penalty = 0.0; penalty < 2.0 * static_cast<double>(count);
       penalty = penalty == 0.0 ? 0.125 : 2.0 * penalty) {
    // Steps of M − dC + sI climb, as s makes it positive definite enough for what is left of u.
    const double shift = penalty * contradiction.colwise().sum().maxCoeff();
    for (int step = 0; step < 200; ++step) {
      const Eigen::VectorXd before = u;
      u = (affinity * u - penalty * (contradiction * u) + shift * u).cwiseMax(0.0);
      u.normalize();
      u = (u.array() < least_share).select(0.0, u);
      if ((u - before).norm() < still) break;
    }
    if (u.dot(contradiction * u) == 0.0) break;
  }
  std::vector<std::size_t> order(static_cast<std::size_t>(count)), chosen;
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto share = [&](std::size_t i) { return u(static_cast<Eigen::Index>(i)); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return share(a) > share(b); });
  for (const std::size_t i : order) {
    if (share(i) <= 0.0) break;
    const bool fits = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      return affinity(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(other)) > 0.0;
    });
    if (fits) chosen.push_back(i);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}
