// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include <Eigen/Core>

#include <topobag/types/image_descriptor.hpp>

inline const topobag::ImageKind& test_image_kind() {
  static const topobag::ImageKind kind("test", 24);
  return kind;
}

/// One of six directions, blurred; one in four is unknown.
inline topobag::ImageDescriptor random_image(std::mt19937& random) {
  if (random() % 4 == 0) return {};
  std::normal_distribution<double> normal;
  Eigen::VectorXd vector(24);
  for (double& x : vector) x = 0.2 * normal(random);
  vector(static_cast<Eigen::Index>(random() % 6)) += 1.0;
  return {test_image_kind(), vector};
}
