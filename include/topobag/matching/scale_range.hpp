// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// What is known of the scale where a front end does not know its unit, as a monocular one: how
/// many of the candidate's metres a unit of the query may be, evenly in its logarithm.
///
/// All that is stated in metres (gates, tolerances, radii) is meant in the candidate's.
struct ScaleRange {
  double least = 0.25;         ///< candidate's metres in a unit of the query, > 0
  double greatest = 4.0;       ///< likewise, > `least`
  std::size_t max_tried = 6;   ///< scales that are tried: those that most pairs of objects agree on
  double max_deviation = 0.2;  ///< of the scale's logarithm; a pose whose scale is less certain is
                               ///< degenerate

  /// Whether the scale is in the range.
  bool contains(double scale) const noexcept { return scale >= least && scale <= greatest; }

  /// Of the logarithm, natural. Throws InvalidValue for a range that is none.
  double log_width() const {
    if (!(least > 0.0 && greatest > least && std::isfinite(greatest))) {
      throw InvalidValue("a range of scales goes from a positive number to a greater one");
    }
    return std::log(greatest / least);
  }
};

}  // namespace v0
}  // namespace topobag
