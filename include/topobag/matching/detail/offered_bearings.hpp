// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/graph/bearing.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/bearing_chance.hpp>
#include <topobag/matching/bearing_options.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/matching/correspondence.hpp>
#include <topobag/matching/point_pair.hpp>
#include <topobag/sensing/node_noise.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// ln of the size of an object over its box's extent, the mean of width and height: of its depth,
/// m. Nothing where a size is unknown.
inline std::optional<double> log_depth_by_size(const Eigen::Vector2d& size,
                                               const Eigen::Vector2d& extent) {
  if (!(size.minCoeff() > 0.0 && extent.minCoeff() > 0.0)) return std::nullopt;
  return 0.5 * std::log(size.x() * size.y() / (extent.x() * extent.y()));
}

/// An object of a map and a bearing that may be of it.
struct OfferedBearing {
  Correspondence pair;
  Eigen::Vector3d target;                ///< m, map's frame
  Eigen::Matrix3d target_covariance;     ///< m²
  double size = 0.0;                     ///< m, of the object; 0 = unknown
  Eigen::Vector3d direction;             ///< unit vector, camera's frame
  double deviation = 0.0;                ///< rad
  std::optional<double> log_depth;       ///< ln of the depth in m that the sizes tell
  double nearest = 0.0, farthest = 0.0;  ///< m, how far away the object may be

  /// The same as two points: what it says of a pose, to first order. The bearing's is as far away
  /// as the pose has the object, and open along the ray.
  template <typename Pose>
  PointPair at(const Pose& T_target_camera) const {
    const double open = 100.0;  // m
    return at((target - T_target_camera.translation()).norm(), open);
  }

  /// The same, as far away as the sizes tell, of which the logarithm has a standard deviation of
  /// `size_deviation`; open where they tell nothing, or contradict the pose by three of these.
  template <typename Pose>
  PointPair sized_at(const Pose& T_target_camera, double size_deviation) const {
    const double depth = (T_target_camera.inverse() * target).z();
    if (!log_depth || !(depth > 0.0)) return at(T_target_camera);
    const double ratio = *log_depth - std::log(depth);
    if (std::abs(ratio) > 3.0 * size_deviation) return at(T_target_camera);
    const double range = (target - T_target_camera.translation()).norm();
    return at(range * std::exp(ratio), range * size_deviation);
  }

  /// The same, `range` m away, with a standard deviation of `along` m.
  template <typename Range>
  PointPair at(Range range, Range along) const {
    const Eigen::Matrix3d ray = direction * direction.transpose();
    const double across = range * deviation;
    return {target,
            range * direction,
            target_covariance,
            across * across * (Eigen::Matrix3d::Identity() - ray) + along * along * ray,
            size * target.normalized(),
            size * direction};
  }
};

/// What a pair shows under a pose, as angles.
template <typename Pose>
BearingPair bearing_pair(const OfferedBearing& pair, const Pose& T) {
  const PointPair points = pair.at(T);
  const Eigen::Vector3d ray = T.linear() * pair.direction;
  Eigen::Matrix<double, 3, 2> across;
  across.col(0) = ray.unitOrthogonal();
  across.col(1) = ray.cross(across.col(0));
  const double range = points.source.norm();
  BearingPair seen;
  seen.direction = pair.direction;
  seen.covariance = across.transpose() * points.covariance(T) * across / (range * range);
  seen.squared_deviation = points.squared_deviation(T);
  const double depth = (T.inverse() * pair.target).z();
  if (pair.log_depth && depth > 0.0) seen.size_ratio = *pair.log_depth - std::log(depth);
  return seen;
}

/// Whether two pairs can hold at once: somewhere within their ranges the two rays are as far apart
/// as the two objects, give or take `tolerance` m.
inline bool may_agree(const OfferedBearing& a, const OfferedBearing& b, double tolerance) {
  if (a.pair.query == b.pair.query || a.pair.candidate == b.pair.candidate) return false;
  const double distance = (a.target - b.target).norm();
  const double cosine = a.direction.dot(b.direction);
  const auto apart = [&](double s, double t) {
    return std::sqrt(std::max(0.0, s * s + t * t - 2.0 * s * t * cosine));
  };
  double most = 0.0, least = apart(a.nearest, b.nearest);
  for (const double s : {a.nearest, a.farthest}) {
    for (const double t : {b.nearest, b.farthest}) most = std::max(most, apart(s, t));
    least = std::min(least, apart(s, std::clamp(s * cosine, b.nearest, b.farthest)));
  }
  for (const double t : {b.nearest, b.farthest}) {
    least = std::min(least, apart(std::clamp(t * cosine, a.nearest, a.farthest), t));
  }
  return least - tolerance <= distance && distance <= most + tolerance;
}

/// All pairs of one group of classes, those of the rarest groups first. O(n · k).
template <typename Scalar>
std::vector<OfferedBearing> offered_bearings(const TopologyGraph<Scalar>& candidate,
                                             const std::vector<Bearing>& bearings,
                                             const ClassGroups& classes, const NodeNoise& noise,
                                             const BearingOptions& options) {
  std::vector<OfferedBearing> offered;
  std::map<ClassId, std::size_t> of_group;
  for (std::size_t q = 0; q < bearings.size(); ++q) {
    const Bearing& bearing = bearings[q];
    for (std::size_t p = 0; p < candidate.size(); ++p) {
      const auto& node = candidate.nodes()[p];
      if (!node.position || !classes.compatible(node.label, bearing.label)) continue;
      const Eigen::Vector2d size = node.size.template cast<double>();
      OfferedBearing pair;
      pair.pair = {node_index(p), node_index(q)};
      pair.target = node.position->template cast<double>();
      pair.target_covariance = position_covariance(node, noise);
      pair.size = std::sqrt(std::max(0.0, size.x() * size.y()));
      pair.direction = bearing.direction;
      pair.deviation = bearing.deviation;
      pair.log_depth = log_depth_by_size(size, bearing.extent);
      pair.nearest = options.min_range;
      pair.farthest = options.max_range;
      if (pair.log_depth) {
        const double range = std::exp(*pair.log_depth) / std::max(0.1, bearing.direction.z());
        pair.nearest = std::max(pair.nearest, range / options.max_size_ratio);
        pair.farthest = std::min(pair.farthest, range * options.max_size_ratio);
      }
      if (!(pair.nearest < pair.farthest)) continue;
      ++of_group[classes.group(bearing.label)];
      offered.push_back(pair);
    }
  }
  const auto rank = [&](const OfferedBearing& pair) {
    const ClassId group = classes.group(bearings[value(pair.pair.query)].label);
    return std::make_tuple(of_group[group], group, pair.pair);
  };
  std::sort(offered.begin(), offered.end(),
            [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return offered;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
