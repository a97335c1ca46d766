// SPDX-License-Identifier: MIT
#include "pose_units.hpp"

#include <string>
#include <vector>

#include "catch.hpp"
#include "error_text.hpp"

namespace {

/// What is said of a straight drive at a speed, m/s, with so many seconds between frames.
std::string said_of_drive(double speed, double seconds, int frames = 20) {
  std::vector<program::FrameRow> rows(static_cast<std::size_t>(frames));
  for (int i = 0; i < frames; ++i) {
    auto& row = rows[static_cast<std::size_t>(i)];
    row.timestamp = seconds * i;
    row.T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(speed * seconds * i, 0, 0));
  }
  return error_text([&] { program::require_metres("set.frames.csv", rows); });
}

}  // namespace

TEST_CASE("poses in millimetres are told by how fast the camera moves", "[examples][regression]") {
  for (const double seconds : {0.03, 0.4, 5.0}) {
    CHECK(said_of_drive(0.0, seconds) == "nothing was thrown");
    CHECK(said_of_drive(0.3, seconds) == "nothing was thrown");
    CHECK(said_of_drive(40.0, seconds) == "nothing was thrown");
    CHECK(said_of_drive(300.0, seconds) ==
          "set.frames.csv: the camera moves at 300 m/s; tx, ty, tz are in metres and timestamps in "
          "seconds: are these in millimetres?");
  }
  CHECK(said_of_drive(300.0, 0.4, 3) == "nothing was thrown");  // too few to tell
}

TEST_CASE("a jump from place to place is no speed", "[examples]") {
  std::vector<program::FrameRow> rows(20);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].timestamp = 0.1 * static_cast<double>(i);
    const double x = 200.0 * static_cast<double>(i / 5);
    rows[i].T_world_camera = Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0));
  }
  CHECK(error_text([&] { program::require_metres("set.frames.csv", rows); }) ==
        "nothing was thrown");
  rows[4].T_world_camera.reset();
  rows[7].timestamp = rows[6].timestamp;
  CHECK(error_text([&] { program::require_metres("set.frames.csv", rows); }) ==
        "nothing was thrown");
}
