// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include <topobag/recognition/detail/sim3_with_covariance.hpp>

/// Seven normal numbers.
inline Eigen::Matrix<double, 7, 1> drawn_zeta(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Matrix<double, 7, 1>::NullaryExpr([&] { return normal(random); });
}

/// Any rotation, metres of translation, and a scale about one; exact.
inline topobag::detail::Sim3WithCovariance drawn_sim3(std::mt19937& random) {
  const Eigen::Matrix<double, 7, 1> zeta = drawn_zeta(random);
  const Eigen::Vector3d turn = zeta.segment<3>(3);
  topobag::detail::Sim3WithCovariance motion;
  motion.T = Eigen::Translation3d(2.0 * zeta.head<3>()) *
             Eigen::AngleAxisd(turn.norm(), turn.normalized());
  motion.scale = std::exp(0.4 * zeta(6));
  return motion;
}
