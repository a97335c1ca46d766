// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <topobag/types/stamp.hpp>

#include "input_error.hpp"

namespace program {

/// Throws InputError unless the stamps of a file's frames may be seconds.
/// @param frames    by time
/// @param stamp_of  the stamp of one of them, s
template <typename Frames, typename StampOf>
void require_recorded(const std::string& path, const Frames& frames, const StampOf& stamp_of) {
  try {
    topobag::require_recording(frames, stamp_of);
  } catch (const topobag::InvalidValue& why) {
    throw InputError(path, why.what());
  }
}

/// Asks, of a step between stamps that lies between those of a camera's frames in seconds and in
/// milliseconds, whether it is in these; empty where it may well be in seconds.
inline std::string milliseconds_question(double step) {
  const double longest = 5.0;  // s; in ms of 200 frames a second
  return step >= longest ? ": are the stamps in milliseconds?" : "";
}

/// That a window fuses no frame with another, or minutes of all that was recorded, in a sentence
/// without its full stop; empty where it is as windows are, or fuses none on purpose.
/// @param frames  of a table, by time, each with its `timestamp`, s
/// @param window  s
template <typename Frame>
std::string odd_window_text(const std::vector<Frame>& frames, double window) {
  const std::optional<double> step =
      topobag::middle_step(frames, [](const Frame& frame) { return frame.timestamp; });
  if (!step || window <= 0.0) return "";
  std::ostringstream text;
  text.precision(4);
  const double longest = 60.0;  // s; some twenty times what is of use
  const double recorded = frames.back().timestamp - frames.front().timestamp;
  if (window > longest && window >= recorded) {
    text << "a window of " << window << " s fuses all " << recorded
         << " s of the recording in one graph: is it in milliseconds?";
    return text.str();
  }
  if (*step <= window) return "";
  text << "frames are " << *step << " s apart in the median, a window of " << window
       << " s fuses nothing" << milliseconds_question(*step);
  return text.str();
}

}  // namespace program
