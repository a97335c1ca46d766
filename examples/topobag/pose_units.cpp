// SPDX-License-Identifier: MIT
#include "pose_units.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>

#include "input_error.hpp"

namespace program {

void require_metres(const std::string& source, const std::vector<FrameRow>& frames) {
  std::vector<double> speeds;  // m/s
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const FrameRow& from = frames[i - 1];
    const FrameRow& to = frames[i];
    const double seconds = to.timestamp - from.timestamp;
    if (!from.T_world_camera || !to.T_world_camera || !(seconds > 0.0)) continue;
    const Eigen::Vector3d step =
        to.T_world_camera->translation() - from.T_world_camera->translation();
    speeds.push_back(step.norm() / seconds);
  }
  const std::size_t few = 5;
  if (speeds.size() < few) return;
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  const double fastest = 70.0;  // m/s; a car on a motorway makes 40
  if (*middle <= fastest) return;
  std::ostringstream why;
  why.precision(3);
  why << "the camera moves at " << *middle
      << " m/s; tx, ty, tz are in metres and timestamps in seconds: are these in millimetres?";
  throw InputError(source, why.str());
}

}  // namespace program
