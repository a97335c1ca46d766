// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/evaluation/pose_error.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/refine_pose.hpp>
#include <topobag/matching/rigid_fit.hpp>
#include <topobag/sensing/dynamic_feature_mask.hpp>
#include <topobag/types/class_catalog.hpp>

#include "simulated_features.hpp"

namespace bench {

/// Of which features the camera's motion is estimated.
enum class KeptFeatures {
  all,
  outside_boxes,       ///< the mask knows the boxes of people alone
  not_at_their_depth,  ///< and how far the people are
  on_background        ///< those that stand still, which no program knows
};

inline constexpr std::array<KeptFeatures, 4> all_kept_features{
    KeptFeatures::all, KeptFeatures::outside_boxes, KeptFeatures::not_at_their_depth,
    KeptFeatures::on_background};

inline const char* to_string(KeptFeatures kept) {
  switch (kept) {
    case KeptFeatures::all:
      return "all features";
    case KeptFeatures::outside_boxes:
      return "masked by boxes";
    case KeptFeatures::not_at_their_depth:
      return "masked, with depth";
    default:
      return "background alone";
  }
}

/// The pairs that are left of the features.
inline std::vector<topobag::PointPair> kept_pairs(const SimulatedFeatures& made, KeptFeatures kept,
                                                  const topobag::ClassCatalog& catalog) {
  std::vector<topobag::RangedDetection> boxes;
  if (kept == KeptFeatures::outside_boxes || kept == KeptFeatures::not_at_their_depth) {
    boxes = made.people;
  }
  if (kept == KeptFeatures::outside_boxes) {
    for (topobag::RangedDetection& box : boxes) box.z = 0.0;
  }
  const topobag::DynamicFeatureMask mask(boxes, catalog);
  std::vector<topobag::PointPair> pairs;
  for (const SimulatedFeature& feature : made.features) {
    if (kept == KeptFeatures::on_background && feature.on_person) continue;
    if (!mask(feature.pixel, feature.z)) pairs.push_back(feature.pair);
  }
  return pairs;
}

/// T_first_second by `refined_motion`, whose kernel is robust; nothing for fewer than three pairs.
/// @param start  near the motion; nothing: the rigid motion of least squares over all pairs
inline std::optional<Eigen::Isometry3d> camera_motion(
    const std::vector<topobag::PointPair>& pairs,
    const std::optional<Eigen::Isometry3d>& start = std::nullopt) {
  if (pairs.size() < 3) return std::nullopt;
  Eigen::Isometry3d T_first_second = start.value_or(Eigen::Isometry3d::Identity());
  if (!start) {
    Eigen::Matrix3Xd first(3, static_cast<Eigen::Index>(pairs.size())), second(first);
    Eigen::Index i = 0;
    for (const topobag::PointPair& pair : pairs) {
      first.col(i) = pair.target;
      second.col(i++) = pair.source;
    }
    T_first_second = topobag::fit_rigid(first, second)->T_target_source;
  }
  topobag::RefineOptions options;
  options.iterations = 30;
  options.tolerance = 1e-6;
  return topobag::refined_motion(T_first_second, pairs, options);
}

/// Upper ends of the bands of the share of an image that people cover; none is a band of its own.
inline constexpr std::array<double, 5> covered_band_ends{0.0, 0.1, 0.25, 0.5, 1.0};

/// The band of a share within [0, 1].
inline std::size_t covered_band(double covered) {
  std::size_t band = 0;
  while (band + 1 < covered_band_ends.size() && covered > covered_band_ends[band]) ++band;
  return band;
}

/// How far off the motions of one band are that one choice of features gives.
struct MotionErrors {
  std::vector<double> millimetres, degrees;
  std::size_t none = 0;   ///< had too few features
  std::size_t pairs = 0;  ///< of features, all together

  void add(const std::vector<topobag::PointPair>& kept,
           const std::optional<Eigen::Isometry3d>& start, const Eigen::Isometry3d& truth) {
    pairs += kept.size();
    const auto motion = camera_motion(kept, start);
    if (!motion) {
      ++none;
      return;
    }
    const topobag::PoseError error = topobag::pose_error(truth, *motion);
    millimetres.push_back(1000.0 * error.translation_m);
    degrees.push_back(error.rotation_deg);
  }
};

}  // namespace bench
