// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include <topobag/assert.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A bin and the share of a vote that falls into it.
struct SoftBin {
  std::uint64_t bin = 0;
  double share = 0.0;
};

/// The two bins, centred on multiples of `width`, between which a vote at `distance` ≥ 0 is
/// interpolated linearly. Distances beyond `max_distance` count as equal to it.
/// Precondition: width > 0, 0 <= max_distance < 2³² widths; where that is an exception, it gets
/// out.
inline std::array<SoftBin, 2> soft_bins(double distance, double width, double max_distance) {
  TOPOBAG_ASSERT(width > 0.0 && max_distance >= 0.0 && max_distance < 0x1p32 * width);
  const double place = std::min(distance, max_distance) / width;
  const auto bin = static_cast<std::int64_t>(place);  // the floor, as place >= 0
  const auto below = static_cast<double>(bin);
  const auto word = static_cast<std::uint64_t>(bin);
  return {{{word, 1.0 - (place - below)}, {word + 1, place - below}}};
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
