// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include <topobag/error.hpp>
#include <topobag/evaluation/frustum_overlap.hpp>

namespace topobag {
inline namespace v0 {

/// What a protocol says of a query and a candidate.
enum class PairRelation {
  positive,  ///< the same place: a true loop
  negative,  ///< another place
  ignored,   ///< between: neither right nor wrong, left out of every metric
  excluded,  ///< never asked: the pair itself or its neighbours in time
};

/// The declared definition of a true loop. Give either a distance or a covisibility.
struct PlaceProtocol {
  std::optional<double> distance_m;  ///< d₊: positive up to this distance of the cameras, m
  std::optional<double> angle_deg;  ///< θ₊, degrees; positives are turned by no more than it, too
  /// d₋: negative from this distance on, m. With neither this nor `negative_angle_deg`, all that
  /// are not positive.
  std::optional<double> negative_distance_m;
  std::optional<double> negative_angle_deg;  ///< θ₋: negative from this rotation on, degrees;
                                             ///< goes with `angle_deg`

  std::optional<double> covisibility;  ///< c₊: positive from this overlap on, (0, 1]
  /// c₋: negative up to this overlap; without it, all others are.
  std::optional<double> negative_covisibility;
  std::optional<DepthFrustum> frustum;  ///< what the cameras see; goes with `covisibility`

  double exclude_seconds = 0.0;    ///< pairs closer in time than this are not evaluated, s
  std::size_t exclude_frames = 0;  ///< pairs closer in index than this are not evaluated
  bool past_only = false;          ///< candidates after the query are not evaluated: on-line loops

  /// Throws InvalidValue with what contradicts what.
  void validate() const;
};

/// The relation of two cameras at `distance_m` and `angle_deg` (called when it matters).
/// Precondition: the protocol has a distance.
template <typename Angle>
PairRelation relation_by_distance(const PlaceProtocol& protocol, double distance_m,
                                  Angle&& angle_deg) {
  const bool near = distance_m <= *protocol.distance_m;
  if (near && (!protocol.angle_deg || angle_deg() <= *protocol.angle_deg)) {
    return PairRelation::positive;
  }
  if (!protocol.negative_distance_m && !protocol.negative_angle_deg) return PairRelation::negative;
  if (protocol.negative_distance_m && distance_m >= *protocol.negative_distance_m) {
    return PairRelation::negative;
  }
  const bool turned = protocol.negative_angle_deg && angle_deg() >= *protocol.negative_angle_deg;
  return turned ? PairRelation::negative : PairRelation::ignored;
}

/// The relation of two cameras whose frusta overlap by `overlap`.
/// Precondition: the protocol has a covisibility.
inline PairRelation relation_by_covisibility(const PlaceProtocol& protocol,
                                             double overlap) noexcept {
  if (overlap >= *protocol.covisibility) return PairRelation::positive;
  const bool ignored = protocol.negative_covisibility && overlap > *protocol.negative_covisibility;
  return ignored ? PairRelation::ignored : PairRelation::negative;
}

inline void PlaceProtocol::validate() const {
  const auto require = [](bool condition, const char* sentence) {
    if (!condition) throw InvalidValue(sentence);
  };
  const auto in = [](const std::optional<double>& value, double low, double high) {
    return !value || (*value >= low && *value <= high && std::isfinite(*value));
  };
  const double far = std::numeric_limits<double>::infinity();
  require(distance_m.has_value() != covisibility.has_value(),
          "a protocol calls a pair positive by either a distance or a covisibility; give one");
  require(covisibility.has_value() == frustum.has_value(),
          "a covisibility needs the frustum of the camera, and a frustum a covisibility");
  require(in(distance_m, 0.0, far) && in(negative_distance_m, 0.0, far),
          "a protocol's distances are finite and >= 0");
  require(in(angle_deg, 0.0, 180.0) && in(negative_angle_deg, 0.0, 180.0),
          "a protocol's angles are in [0, 180] degrees");
  require(in(covisibility, 0.0, 1.0) && covisibility != 0.0 && in(negative_covisibility, 0.0, 1.0),
          "a protocol's covisibilities are in (0, 1], the negative one in [0, 1]");
  require(distance_m || !(angle_deg || negative_distance_m || negative_angle_deg),
          "an angle or a negative distance goes with a positive distance");
  require(angle_deg || !negative_angle_deg, "a negative angle goes with a positive one");
  require(covisibility || !negative_covisibility,
          "a negative covisibility goes with a positive one");
  require(!negative_distance_m || *negative_distance_m >= *distance_m,
          "the negative distance is not below the positive one");
  require(!negative_angle_deg || *negative_angle_deg >= *angle_deg,
          "the negative angle is not below the positive one");
  require(!negative_covisibility || *negative_covisibility <= *covisibility,
          "the negative covisibility is not above the positive one");
  require(std::isfinite(exclude_seconds) && exclude_seconds >= 0.0,
          "the excluded time is finite and >= 0");
  if (frustum) frustum->validate();
}

}  // namespace v0
}  // namespace topobag
