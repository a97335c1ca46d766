// SPDX-License-Identifier: MIT
#include "frame_poses.hpp"

#include "catch.hpp"
#include "error_text.hpp"
#include "node_table.hpp"
#include "scratch_folder.hpp"

namespace {

std::vector<program::FrameRow> frames_at(const std::vector<double>& stamps) {
  std::vector<program::FrameRow> frames(stamps.size());
  for (std::size_t i = 0; i < stamps.size(); ++i) frames[i].timestamp = stamps[i];
  return frames;
}

}  // namespace

TEST_CASE("frames take the poses of a trajectory by their time, and those beyond it go",
          "[examples]") {
  const ScratchFolder folder;
  const std::string tum =
      folder.write("tum.txt", "1.00 1 0 0 0 0 0 1\n1.10 2 0 0 0 0 0 1\n1.20 3 0 0 0 0 0 1\n");
  auto frames = frames_at({0.5, 1.05, 1.2, 9.0});
  program::take_poses(tum, frames);
  REQUIRE(frames.size() == 2);
  CHECK(frames[0].T_world_camera->translation().x() == Approx(1.5));
  CHECK(frames[1].T_world_camera->translation().x() == Approx(3.0));
}

TEST_CASE("a trajectory that reaches no frame, or has no times, is refused", "[examples]") {
  const ScratchFolder folder;
  const std::string tum = folder.write("tum.txt", "1.0 1 0 0 0 0 0 1\n1.1 2 0 0 0 0 0 1\n");
  auto frames = frames_at({50.0, 51.0});
  CHECK(error_text([&] {
          program::take_poses(tum, frames);
        }).find(tum + ": 2 poses from 1 to 1.1 s reach none of the images") == 0);
  const std::string kitti = folder.write("kitti.txt", "1 0 0 1 0 1 0 2 0 0 1 3\n");
  CHECK(error_text([&] {
          program::take_poses(kitti, frames);
        }).find(kitti + ": a KITTI trajectory has no time stamps") == 0);
}
