// SPDX-License-Identifier: MIT
#include <sstream>

#include <topobag/error.hpp>
#include <topobag/evaluation/openloris_trajectory.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

LifelongTrajectories lifelong_in(const std::string& text,
                                 RepeatedPoses repeated = RepeatedPoses::drop) {
  std::istringstream stream(text);
  return read_openloris(stream, "cafe.txt", repeated);
}

const std::string header = "scene: cafe\nframe:d400_color\n# comment\nmem(GB): 62\nseq: 1\n";

}  // namespace

TEST_CASE("headers with and without a space, 8 or 9 numbers, any order of stamps", "[evaluation]") {
  const LifelongTrajectories file = lifelong_in(
      "seq:2\nscene:cafe\n" + header +
      "3.5 99.0 1 0 0 0 0 0 1\n2.5 2 0 0 0 0 0 1\naided_reloc: false\nscene: home\nseq: 7\n");
  CHECK(file.scene == "cafe");
  CHECK(file.frame == "d400_color");
  REQUIRE(file.sequences.size() == 3);
  CHECK(file.sequences.at(2).empty());
  CHECK(file.sequences.at(7).empty());
  const Trajectory& first = file.sequences.at(1);
  REQUIRE(first.size() == 2);
  CHECK(first[0].stamp == 2.5);
  CHECK(first[0].T_world_body.translation().x() == 2.0);
  CHECK(first[1].stamp == 3.5);
  CHECK(first[1].T_world_body.translation().x() == 1.0);
}

TEST_CASE("a repeated pose is dropped, across sequences too, unless it is wanted", "[evaluation]") {
  const std::string text = header +
                           "1 5 0 0 0 0 0 1\n2 5 0 0 0 0 0 1\n3 6 0 0 0 0 0 1\n4 5 0 0 0 0 0 1\n"
                           "seq: 2\n9 5 0 0 0 0 0 1\n";
  CHECK(lifelong_in(text).sequences.at(1).size() == 3);
  CHECK(lifelong_in(text).sequences.at(2).empty());
  CHECK(lifelong_in(text, RepeatedPoses::keep).sequences.at(1).size() == 4);
  CHECK(lifelong_in(text, RepeatedPoses::keep).sequences.at(2).size() == 1);
}

TEST_CASE("what is not an OpenLORIS file is refused", "[evaluation]") {
  CHECK_THROWS_AS(lifelong_in("1 0 0 0 0 0 0 1\n"), Error);
  CHECK_THROWS_AS(lifelong_in("seq: one\n"), Error);
  CHECK_THROWS_AS(lifelong_in(header + "seq: 1\n"), Error);
  CHECK_THROWS_AS(lifelong_in(header + "1 0 0 0 0 0 1\n"), Error);
  CHECK_THROWS_AS(lifelong_in(header + "nan 0 0 0 0 0 0 1\n"), Error);
  CHECK_THROWS_AS(lifelong_in(header + "0 0 0 0 0 0 0 1\n33333333 1 0 0 0 0 0 1\n"), Error);
  CHECK_THROWS_AS(lifelong_in(header + "1 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n"), Error);
}

TEST_CASE("the sensors of the robot look where they should", "[evaluation]") {
  for (const char* frame : {"d400_color", "d400_imu", "t265_fisheye1"}) {
    const auto T_base_frame = openloris_T_base_frame(frame);
    REQUIRE(T_base_frame);
    CHECK(T_base_frame->linear().col(2).x() > 0.99);  // z forward
    CHECK(T_base_frame->translation().z() > 0.8);
  }
  CHECK(openloris_T_base_frame("base_link")->isApprox(Eigen::Isometry3d::Identity()));
  CHECK_FALSE(openloris_T_base_frame("laser"));
}
