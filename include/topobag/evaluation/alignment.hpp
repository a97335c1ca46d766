// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include <topobag/evaluation/association.hpp>

namespace topobag {
inline namespace v0 {

/// A similarity transform: x ↦ scale · R · x + t.
struct Alignment {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< R
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();   ///< t, m
  double scale = 1.0;                                      ///< > 0

  /// A body's pose in the target's world: the position is transformed, the rotation turned.
  template <int Mode, int Options>
  Eigen::Isometry3d operator*(const Eigen::Transform<double, 3, Mode, Options>& pose) const {
    Eigen::Isometry3d aligned = Eigen::Isometry3d::Identity();
    aligned.linear() = rotation * pose.linear();
    aligned.translation() = scale * (rotation * pose.translation()) + translation;
    return aligned;
  }
};

/// What an alignment may change.
enum class AlignmentModel {
  none,  ///< the estimate is in the ground truth's world already
  se3,   ///< rotation and translation (Horn, JOSA 1987)
  sim3,  ///< and scale, for monocular systems (Umeyama, PAMI 1991)
};

/// The least-squares alignment of the estimated onto the true positions. Where they do not
/// determine a rotation (fewer than three, or on a line) it is one of the best; where they do
/// not determine a scale it is 1, and without a pair the alignment is the identity. O(n).
/// @param pairs  a vector of `PosePair`
template <typename Pairs = std::vector<PosePair>>
Alignment align(const Pairs& pairs, AlignmentModel model = AlignmentModel::se3) {
  Alignment alignment;
  if (pairs.empty() || model == AlignmentModel::none) return alignment;
  const auto n = static_cast<Eigen::Index>(pairs.size());
  Eigen::Matrix3Xd estimated(3, n);
  Eigen::Matrix3Xd truth(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& pair = pairs[static_cast<std::size_t>(i)];
    estimated.col(i) = pair.T_estimate.translation();
    truth.col(i) = pair.T_true.translation();
  }
  const Eigen::Vector3d center = estimated.rowwise().mean();
  const Eigen::Vector3d true_center = truth.rowwise().mean();
  alignment.rotation = Eigen::umeyama(estimated, truth, false).topLeftCorner<3, 3>();
  if (model == AlignmentModel::sim3) {
    estimated.colwise() -= center;
    truth.colwise() -= true_center;
    const double overlap = truth.cwiseProduct(alignment.rotation * estimated).sum();
    const double extent = estimated.squaredNorm();
    if (overlap > 0.0 && extent > 0.0) alignment.scale = overlap / extent;
  }
  alignment.translation = true_center - alignment.scale * (alignment.rotation * center);
  return alignment;
}

/// The pairs with the estimates brought into the ground truth's world.
/// @param pairs  a range of `PosePair`
template <typename Pairs = std::vector<PosePair>>
Pairs aligned(Pairs pairs, const Alignment& alignment) {
  for (auto& pair : pairs) pair.T_estimate = alignment * pair.T_estimate;
  return pairs;
}

}  // namespace v0
}  // namespace topobag
