// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include <topobag/types/detail/one_alignment.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Points as `fit_rigid` takes them, each pair weighted by its mean variance.
struct PointSets {
  /// @param points  a vector of `PointPair`
  template <typename Points>
  explicit PointSets(const Points& points) : weights(static_cast<Eigen::Index>(points.size())) {
    target.resize(3, weights.size());
    source.resize(3, weights.size());
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      const auto& pair = points[static_cast<std::size_t>(i)];
      target.col(i) = pair.target;
      source.col(i) = pair.source;
      weights(i) = 1.0 / (pair.target_covariance.trace() + pair.source_covariance.trace() + 1e-4);
    }
  }
  Eigen::Matrix3Xd target, source;
  Eigen::VectorXd weights;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
