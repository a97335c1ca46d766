// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include <Eigen/Core>

#include <topobag/bag/detail/codec/node_layout.hpp>
#include <topobag/bag/detail/codec/packed_column.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/gravity.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Steps from the middle of the unfolded octahedron to its border.
inline constexpr std::int64_t octahedron_steps = 8191;
inline constexpr ColumnRange octahedron_range{-octahedron_steps, octahedron_steps};
inline constexpr unsigned octahedron_width = 14;
inline constexpr ColumnRange tilt_range{-96, 31};  // 1/8 octave from 1 rad: 0.24 mrad to 14.7 rad
inline constexpr unsigned tilt_width = 7;

/// A place on the unfolded octahedron (Meyer et al. 2010): the half with z >= 0 is the diamond
/// |x| + |y| <= 1 of a square, the other one is folded out into its corners.
using OctahedronPlace = std::pair<std::int64_t, std::int64_t>;

/// The direction's place, rounded; off by at most 0.3 mrad. A point of the border stands in it
/// twice, of which the one with the positive coordinate is taken.
inline OctahedronPlace octahedron_place(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d p = direction / direction.cwiseAbs().sum();
  double x = p.x(), y = p.y();
  if (p.z() < 0.0) {
    x = std::copysign(1.0 - std::abs(p.y()), p.x());
    y = std::copysign(1.0 - std::abs(p.x()), p.y());
  }
  const auto steps = [](double share) {
    return quantized(share, static_cast<double>(octahedron_steps), octahedron_range);
  };
  OctahedronPlace place{steps(x), steps(y)};
  const bool at_side = std::abs(place.first) == octahedron_steps;
  const bool at_end = std::abs(place.second) == octahedron_steps;
  if (at_side) place.second = std::abs(place.second);
  if (at_end) place.first = std::abs(place.first);
  return place;
}

/// The direction at that place.
inline Eigen::Vector3d direction_at(const OctahedronPlace& place) {
  const double x = static_cast<double>(place.first) / static_cast<double>(octahedron_steps);
  const double y = static_cast<double>(place.second) / static_cast<double>(octahedron_steps);
  const double z = 1.0 - std::abs(x) - std::abs(y);
  if (z >= 0.0) return Eigen::Vector3d(x, y, z).normalized();
  return Eigen::Vector3d(std::copysign(1.0 - std::abs(y), x), std::copysign(1.0 - std::abs(x), y),
                         z)
      .normalized();
}

/// Writes the gravity of a graph.
template <typename Scalar>
void put_gravity(BitWriter& writer, const Gravity<Scalar>& gravity) {
  const auto put = [&](std::int64_t value, ColumnRange range, unsigned width) {
    writer.put(static_cast<std::uint64_t>(value - range.low), width);
  };
  const OctahedronPlace place = octahedron_place(gravity.down.template cast<double>());
  put(place.first, octahedron_range, octahedron_width);
  put(place.second, octahedron_range, octahedron_width);
  put(quantized(std::log2(static_cast<double>(gravity.deviation)), steps_per_octave, tilt_range),
      tilt_range, tilt_width);
}

/// Throws FormatError.
template <typename Scalar>
Gravity<Scalar> get_gravity(BitReader& reader) {
  const auto get = [&](ColumnRange range, unsigned width) {
    const std::int64_t value = range.low + static_cast<std::int64_t>(reader.get(width));
    if (value > range.high) {
      throw FormatError("the data hold a number out of range: they are damaged");
    }
    return value;
  };
  const std::int64_t x = get(octahedron_range, octahedron_width);
  const std::int64_t y = get(octahedron_range, octahedron_width);
  const std::int64_t tilt = get(tilt_range, tilt_width);
  return {direction_at({x, y}).template cast<Scalar>(),
          static_cast<Scalar>(std::exp2(static_cast<double>(tilt) / steps_per_octave))};
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
