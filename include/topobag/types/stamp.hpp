// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

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

/// From one frame of a recording to the next, in the median, s: no camera waits longer.
inline constexpr double longest_middle_step = 3600.0;
/// From the first frame of a recording to its last, s: ten years.
inline constexpr double longest_recording = 10.0 * 365.25 * 86400.0;

/// The median of the steps between stamps in the order of time, s; of two the longer one.
/// Nothing without two stamps. O(n).
/// @param frames    a range in that order
/// @param stamp_of  the stamp of one of them, s
template <typename Frames, typename StampOf>
std::optional<double> middle_step(const Frames& frames, const StampOf& stamp_of) {
  std::vector<double> steps;
  std::optional<double> before;
  for (const auto& frame : frames) {
    const double stamp = stamp_of(frame);
    if (before) steps.push_back(stamp - *before);
    before = stamp;
  }
  if (steps.empty()) return std::nullopt;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// Throws InvalidValue unless the stamps of one recording, in the order of time, may be seconds:
/// each by itself may be where time counts from 0, as a simulator's does, in another unit. What
/// every reader of frames or poses with stamps holds them to. O(n).
/// @param frames    a range in that order
/// @param stamp_of  the stamp of one of them, s
template <typename Frames, typename StampOf>
void require_recording(const Frames& frames, const StampOf& stamp_of) {
  const std::optional<double> step = middle_step(frames, stamp_of);
  if (!step) return;
  if (*step > longest_middle_step) {
    throw InvalidValue(
        "the time stamps are " + std::to_string(*step) +
        " s apart in the median, longer than any recording waits; are they in " +
        (*step < 3e6 ? "microseconds? divide by 1e6" : "nanoseconds? divide by 1e9"));
  }
  const double first = stamp_of(*std::begin(frames)), last = stamp_of(*std::prev(std::end(frames)));
  if (last - first <= longest_recording) return;
  throw InvalidValue("the time stamps reach from " + std::to_string(first) + " to " +
                     std::to_string(last) +
                     " s, over more than ten years; are all in seconds and of one clock?");
}

}  // namespace v0
}  // namespace topobag
