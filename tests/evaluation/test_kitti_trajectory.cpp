// SPDX-License-Identifier: MIT
#include <sstream>

#include <topobag/error.hpp>
#include <topobag/evaluation/kitti_trajectory.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

Trajectory kitti_poses(const std::string& text) {
  std::istringstream stream(text);
  return read_kitti(stream, "00.txt");
}

const char* const two_poses =
    "1 0 0 0 0 1 0 0 0 0 1 0\n"
    "0 -1 0 4 1 0 0 5 0 0 1 6\n";

}  // namespace

TEST_CASE("a KITTI trajectory is 3×4 matrices, row by row", "[evaluation]") {
  Trajectory trajectory = kitti_poses(two_poses);
  REQUIRE(trajectory.size() == 2);
  CHECK(trajectory[0].T_world_body.isApprox(Eigen::Isometry3d::Identity()));
  CHECK(trajectory[1].T_world_body.translation() == Eigen::Vector3d(4, 5, 6));
  CHECK(trajectory[1].T_world_body.linear().col(0).isApprox(Eigen::Vector3d::UnitY()));
  CHECK(trajectory[1].stamp == 1.0);

  std::istringstream times("0.0\n1.037e-01\n");
  read_kitti_times(times, "times.txt", trajectory);
  CHECK(trajectory[1].stamp == 0.1037);
}

TEST_CASE("what is not a KITTI trajectory is refused", "[evaluation]") {
  CHECK_THROWS_AS(kitti_poses("1 0 0 0 0 1 0 0 0 0 1\n"), Error);
  CHECK_THROWS_AS(kitti_poses("2 0 0 0 0 1 0 0 0 0 1 0\n"), Error);
  CHECK_THROWS_AS(kitti_poses("-1 0 0 0 0 1 0 0 0 0 1 0\n"), Error);  // mirrored
  CHECK_THROWS_AS(kitti_poses("1 0 0 nan 0 1 0 0 0 0 1 0\n"), Error);
  Trajectory trajectory = kitti_poses(two_poses);
  for (const char* text :
       {"0\n", "0\n0\n", "0\n1\n2\n", "0 0\n1 1\n", "0\nnan\n", "0\n103700000\n"}) {
    std::istringstream times(text);
    CHECK_THROWS_AS(read_kitti_times(times, "times.txt", trajectory), Error);
    CHECK(trajectory[1].stamp == 1.0);
  }
}
