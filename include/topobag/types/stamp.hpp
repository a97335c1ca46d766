// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// No moment is as far from 0, s: the year 5138 since 1970. Milli-, micro- and nanoseconds since
/// 1970 all are further.
inline constexpr double largest_stamp = 1e11;

/// Throws InvalidValue unless `stamp` may be a time in seconds: what every stamp is held to,
/// wherever it comes in.
inline void require_seconds(double stamp) {
  if (!std::isfinite(stamp)) throw InvalidValue("the time stamp is not finite");
  if (std::abs(stamp) <= largest_stamp) return;
  const double since_1970 = std::abs(stamp);
  const char* const unit = since_1970 < 1e14   ? "milliseconds? divide by 1e3"
                           : since_1970 < 1e17 ? "microseconds? divide by 1e6"
                                               : "nanoseconds? divide by 1e9";
  throw InvalidValue("the time stamp " + std::to_string(stamp) +
                     " is no time in seconds; is it in " + unit);
}

}  // namespace v0
}  // namespace topobag
