// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <topobag/recognition/recognition.hpp>
#include <topobag/sensing/sensor_profile.hpp>

namespace topobag {
inline namespace v0 {

/// How far apart two cameras may be and still be said to be at one place.
struct PlaceScale {
  double translation = default_sensor.pose_resolution;  ///< m
  double rotation = 0.5236;                             ///< rad, 30°
};

/// How sure it is that a candidate was taken from about where the query was, in [0, 1]: what to
/// rank candidates by when the question is a place, not a pose.
///
/// A verified match says where the query's camera stood. One desk seen from two sides is a good
/// match and a valid loop, yet not one place: with s the score of the pose and (t, θ) the motion
/// between the two cameras, a candidate that passed every stage, or all that were asked of it alone
/// (`CandidateReport::judged_by`), gets ½ (1 + s / (1 + s)) · exp(−½ (t / translation)² −
/// ½ (θ / rotation)²), any other ¼ of its similarity.
template <typename Report = CandidateReport>
double place_score(const Report& report, const PlaceScale& scale = {}) {
  if (!is_verified(report.verdict) && !report.judged_by) return 0.25 * report.similarity;
  const auto& T = report.pose->T_candidate_query;
  const double t = T.translation().norm() / scale.translation;
  const double turn = Eigen::AngleAxisd(T.linear()).angle() / scale.rotation;
  const double s = std::max(0.0, report.score());
  return 0.5 * (1.0 + s / (1.0 + s)) * std::exp(-0.5 * (t * t + turn * turn));
}

}  // namespace v0
}  // namespace topobag
