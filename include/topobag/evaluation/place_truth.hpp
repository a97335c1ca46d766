// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/assert.hpp>
#include <topobag/evaluation/place_protocol.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/evaluation/trajectory.hpp>

namespace topobag {
inline namespace v0 {

/// Which pairs of key frames show the same place: a protocol over true camera poses.
/// @tparam Scalar_  that the poses are kept in
template <typename Scalar_ = double>
class BasicPlaceTruth {
 public:
  using Scalar = Scalar_;
  using Pose = Eigen::Transform<Scalar, 3, Eigen::Isometry>;

  /// Loops within one trajectory: every key frame is a query and a candidate. The pair of a key
  /// frame with itself is excluded, and the protocol's exclusions hold. Throws InvalidValue.
  BasicPlaceTruth(const PlaceProtocol& protocol, const Trajectory& places)
      : protocol_(protocol), queries_(rows(places)), map_(queries_), one_trajectory_(true) {
    protocol_.validate();
  }

  /// Re-localization of `queries` in the map of another trajectory, in the same world. The
  /// protocol's exclusions are about one trajectory: throws InvalidValue when it has any.
  BasicPlaceTruth(const PlaceProtocol& protocol, const Trajectory& queries, const Trajectory& map)
      : protocol_(protocol), queries_(rows(queries)), map_(rows(map)), one_trajectory_(false) {
    protocol_.validate();
    if (protocol.exclude_seconds > 0.0 || protocol.exclude_frames > 0 || protocol.past_only) {
      throw InvalidValue(
          "a protocol excludes neighbours within one trajectory only, not between a query "
          "trajectory and a map");
    }
  }

  /// Poses of the query trajectory.
  std::size_t num_queries() const noexcept { return queries_.size(); }
  /// Poses of the map's trajectory.
  std::size_t num_candidates() const noexcept { return map_.size(); }
  /// By which pairs are judged.
  const PlaceProtocol& protocol() const noexcept { return protocol_; }

  /// What the protocol says of a pair. O(1).
  PairRelation relation(std::size_t query, std::size_t candidate) const {
    TOPOBAG_ASSERT(query < queries_.size() && candidate < map_.size());
    const Row& q = queries_[query];
    const Row& c = map_[candidate];
    if (one_trajectory_) {
      const std::size_t gap = query > candidate ? query - candidate : candidate - query;
      if (gap == 0 || gap < protocol_.exclude_frames) return PairRelation::excluded;
      if (std::abs(q.stamp - c.stamp) < protocol_.exclude_seconds) {
        return PairRelation::excluded;
      }
      if (protocol_.past_only && candidate > query) return PairRelation::excluded;
    }
    if (protocol_.covisibility) {
      const Eigen::Isometry3d T = T_candidate_query(query, candidate).template cast<double>();
      return relation_by_covisibility(protocol_, frustum_overlap(*protocol_.frustum, T));
    }
    const auto distance_m = static_cast<double>((q.position - c.position).norm());
    return relation_by_distance(protocol_, distance_m, [&] {
      return rotation_angle_deg(c.orientation.conjugate() * q.orientation);
    });
  }

  /// The true relative pose of a pair.
  Pose T_candidate_query(std::size_t query, std::size_t candidate) const {
    return map_[candidate].pose().inverse(Eigen::Isometry) * queries_[query].pose();
  }

 private:
  struct Row {
    double stamp;
    Eigen::Matrix<Scalar, 3, 1> position;
    Eigen::Quaternion<Scalar> orientation;

    Pose pose() const { return Eigen::Translation<Scalar, 3>(position) * orientation; }
  };

  static std::vector<Row> rows(const Trajectory& trajectory) {
    std::vector<Row> rows;
    rows.reserve(trajectory.size());
    for (const StampedPose& pose : trajectory) {
      const auto T = pose.T_world_body.template cast<Scalar>();
      rows.push_back({pose.stamp, T.translation(), Eigen::Quaternion<Scalar>(T.linear())});
    }
    return rows;
  }

  PlaceProtocol protocol_;
  std::vector<Row> queries_;
  std::vector<Row> map_;
  bool one_trajectory_;
};

/// The truth over poses of double.
using PlaceTruth = BasicPlaceTruth<>;

}  // namespace v0
}  // namespace topobag
