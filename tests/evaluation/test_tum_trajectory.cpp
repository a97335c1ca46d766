// SPDX-License-Identifier: MIT
#include <sstream>

#include <topobag/error.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;

namespace {

Trajectory tum_poses(const std::string& text) {
  std::istringstream stream(text);
  return read_tum(stream, "room.txt");
}

std::string tum_complaint(const std::string& text) {
  return error_text([&] { tum_poses(text); });
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a TUM trajectory with comments, blanks, tabs and CR LF", "[evaluation]") {
  const Trajectory trajectory = tum_poses(
      "# timestamp tx ty tz qx qy qz qw\r\n\r\n1305031102.1758 1.5 -2e-1 3 0 0 0.7071 0.7071\r\n"
      "\t1305031102.2 0 0 0\t0 0 0 -1");
  REQUIRE(trajectory.size() == 2);
  CHECK(trajectory[0].stamp == 1305031102.1758);
  CHECK(trajectory[0].T_world_body.translation() == Eigen::Vector3d(1.5, -0.2, 3.0));
  CHECK(trajectory[0].T_world_body.linear().col(0).isApprox(Eigen::Vector3d::UnitY()));
  CHECK(trajectory[0].T_world_body.linear().determinant() == Approx(1.0).epsilon(1e-14));
  CHECK(trajectory[1].T_world_body.linear().isIdentity());
  CHECK(tum_poses("").empty());
}

TEST_CASE("what is not a TUM trajectory is refused with file and line", "[evaluation]") {
  const std::string good = "1 0 0 0 0 0 0 1\n";
  CHECK(contains(tum_complaint(good + "# c\n2 0 0 0 0 0 1\n"), "room.txt:3: "));
  CHECK(contains(tum_complaint(good + "2 0 0 0 0 0 0 1 0\n"), "8 numbers"));
  CHECK(contains(tum_complaint(good + "1 0 0 0 0 0 0 1\n"), ":2: the time stamp is not later"));
  CHECK(contains(tum_complaint(good + "0.5 0 0 0 0 0 0 1\n"), ":2: the time stamp is not later"));
  CHECK(contains(tum_complaint("1 0 0 x7 0 0 0 1\n"), ":1: 'x7' is not a number"));
  CHECK(contains(tum_complaint("1 0 0 1,5 0 0 0 1\n"), "is not a number"));
  CHECK(contains(tum_complaint("1 0 0 1.5m 0 0 0 1\n"), "'1.5m' is not a number"));
  CHECK(contains(tum_complaint("1 0 0 nan 0 0 0 1\n"), "not finite"));
  CHECK(contains(tum_complaint("inf 0 0 0 0 0 0 1\n"), "not finite"));
  CHECK(contains(tum_complaint("1 0 0 1e999 0 0 0 1\n"), "is not a number"));
  CHECK(contains(tum_complaint("1 0 0 0 0 0 0 1.1\n"), "unit length"));
  CHECK(contains(tum_complaint("1 0 0 0 0 0 0 0\n"), "unit length"));
  CHECK_NOTHROW(tum_poses("1 0 0 0 0 0 0 1.009\n"));
}

TEST_CASE("a missing file is named", "[evaluation]") {
  CHECK_THROWS_AS(read_tum("there/is/no/such.txt"), Error);
}

TEST_CASE("what is written is read back", "[evaluation]") {
  std::mt19937 random(3);
  const Trajectory trajectory = topobag_tests::random_trajectory(random, 200);
  std::ostringstream text;
  write_tum(text, trajectory);
  const Trajectory again = tum_poses(text.str());
  REQUIRE(again.size() == trajectory.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    CHECK(again[i].stamp == trajectory[i].stamp);
    CHECK(again[i].T_world_body.translation() == trajectory[i].T_world_body.translation());
    CHECK(again[i].T_world_body.linear().isApprox(trajectory[i].T_world_body.linear(), 1e-14));
  }
}

TEST_CASE("a header that names w first is refused, with or without nanoseconds",
          "[evaluation][regression]") {
  const std::string euroc =
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z "
      "[]\n";
  const std::string told =
      "room.txt:2: the header above names the quaternion's w first, as EuRoC's";
  CHECK(contains(tum_complaint(euroc + "1403636580.83,0,0,0,1,0,0,0\n"), told));
  CHECK(contains(tum_complaint(euroc + "1403636580838555648,0,0,0,1,0,0,0,0,0,0\n"), told));
  CHECK(contains(tum_complaint("# t tx ty tz qw qx qy qz\n1 0 0 0 1 0 0 0\n"), told));
  for (const char* header : {"", "# timestamp tx ty tz qx qy qz qw", "# queue of wax", "#qx,qw"}) {
    CHECK_FALSE(names_w_first(std::string(header)));
  }
}

TEST_CASE("stamps from 0 in another unit are told by the steps between them",
          "[evaluation][regression]") {
  const auto told = [](double frame) {
    std::ostringstream text;
    for (int i = 0; i < 30; ++i) text << std::fixed << i * frame << " 0 0 0 0 0 0 1\n";
    return tum_complaint(text.str());
  };
  CHECK(
      contains(told(33333.0), "room.txt: the time stamps are 33333.000000 s apart in the median"));
  CHECK(contains(told(33333333.0), "are they in nanoseconds? divide by 1e9"));
  CHECK(told(33.3) == "nothing was thrown");
}
