// SPDX-License-Identifier: MIT
#include <string>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "pose_files.hpp"
#include "run_program.hpp"
#include "sample.hpp"
#include "scratch.hpp"

using namespace program;

namespace {

/// What is said of a file of poses.
std::string pose_complaint(const std::string& text) {
  const ScratchFolder folder;
  return error_in(folder, [&] { read_pose_file(folder.write("p.txt", text)); });
}

const std::string kitti_line = "1 0 0 0 0 1 0 0 0 0 1 0\n";

}  // namespace

TEST_CASE("a file of poses is told by its content", "[examples]") {
  const ScratchFolder folder;
  const auto format = [&](const std::string& text) {
    return read_pose_file(folder.write("p", text)).format;
  };
  CHECK(format("\xEF\xBB\xBF# t\n1,0,0,0,0,0,0,1\n") == PoseFormat::tum);
  CHECK(format(kitti_line) == PoseFormat::kitti);
  CHECK(format("topics: a, b, c\nseq: 1\n1 0 0 0 0 0 0 1\n") == PoseFormat::openloris);
  CHECK(format("timestamp,tx,ty,tz,qx,qy,qz,qw\n1,0,0,0,0,0,0,1\n") == PoseFormat::frames);
  CHECK_FALSE(read_pose_file(folder.write("p", kitti_line)).stamped);
  CHECK(read_pose_file(folder.write("p", kitti_line), folder.write("times.txt", "5\n")).stamped);
}

TEST_CASE("what holds no poses is refused, whatever it looks like", "[examples][regression]") {
  CHECK(pose_complaint("") == "p.txt: there is no pose in the file");
  CHECK(pose_complaint("[INFO] [1.5]: tracking started\n").find("p.txt:1: this begins no file") ==
        0);
  CHECK(pose_complaint("INFO: tracking started\n") == "p.txt: there is no pose in the file");
  CHECK(pose_complaint("seq: 1\nseq: 2\n") == "p.txt: there is no pose in the file");
  CHECK(pose_complaint("12:00:00.000 1 0 0 0 0 0 1\n").find("p.txt:1: this begins no file") == 0);
  for (const std::string line : {"1;0;0;0;0;0;0;1\r\n", "1,5 0,0 0,0 0,0 0,0 0,0 0,0 1,0\n"}) {
    CHECK(pose_complaint(line) ==
          "p.txt:1: numbers are separated by blanks or by commas, not by semicolons, and decimals "
          "have a point");
  }
  CHECK(pose_complaint("\x02\x7F:\x01\n") == "p.txt:1: this is no text; is it the right file?");
  CHECK(pose_complaint("1 2 3\n").find("p.txt:1: here are 3 numbers") == 0);
  CHECK(pose_complaint("seq: 1\n1 0 0 0 0 0 0 1\n2.0: 1 0 0 0 0 0 1\n") ==
        "p.txt:3: '2.0:' is not a number.");
}

TEST_CASE("poses without stamps go with others without, or with times", "[examples]") {
  const ScratchFolder folder;
  const std::string kitti = folder.write("kitti.txt", kitti_line + kitti_line + kitti_line);
  const std::string tum =
      folder.write("tum.txt", "0 0 0 0 0 0 0 1\n0.1 0 0 0 0 0 0 1\n0.2 0 0 0 0 0 0 1\n");
  const std::string times = folder.write("times.txt", "0\n0.1\n0.2\n");
  CHECK(refusal("trajectory --groundtruth " + kitti + " --estimate " + tum) ==
        kitti + ": a KITTI trajectory has no time stamps, the other one has: give --times");
  CHECK(refusal("trajectory --groundtruth " + tum + " --estimate " + kitti).find(kitti) == 0);
  CHECK(run_program("trajectory --groundtruth " + kitti + " --estimate " + kitti).exit_code == 0);
  CHECK(
      run_program("trajectory --groundtruth " + kitti + " --estimate " + tum + " --times " + times)
          .exit_code == 0);
}

TEST_CASE("a trajectory that matches no true pose is an error that names both clocks",
          "[examples]") {
  const ScratchFolder folder;
  const std::string truth = folder.write("gt.txt", "1000 0 0 0 0 0 0 1\n1001 0 0 0 0 0 0 1\n");
  const std::string estimate = folder.write("est.txt", "1 0 0 0 0 0 0 1\n");
  CHECK(
      refusal("trajectory --groundtruth " + truth + " --estimate " + estimate) ==
      estimate +
          ": no pose lies between two true ones of its time: 1 poses from 1 to 1 s, the truth has "
          "2 poses from 1000 to 1001 s; are both of one clock?");
}

TEST_CASE("a table stands for the poses of its frames", "[examples][regression]") {
  const std::string scored = "trajectory --json --estimate " + sample_map + ".frames.csv";
  const ProgramRun by_file = run_program(scored + " --groundtruth " + sample_map + ".frames.csv");
  const ProgramRun by_set = run_program(scored + " --groundtruth " + sample_map);
  CHECK(by_set.exit_code == 0);
  CHECK(nlohmann::json::parse(by_set.out).at("sequences") ==
        nlohmann::json::parse(by_file.out).at("sequences"));
  CHECK(refusal("trajectory --estimate a --groundtruth " + sample_map + "s") ==
        sample_map + "s: the file cannot be opened; check the path");
}

TEST_CASE("EuRoC's poses are told with what to do, before and after they are in seconds",
          "[examples][regression]") {
  const std::string header =
      "#timestamp,p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []";
  const std::string told = "p.txt:2: the header above names the quaternion's w first, as EuRoC's";
  CHECK(pose_complaint(header + "\n1403636580.8,4,1,0.6,0.5,-0.1,-0.8,-0.2\n").find(told) == 0);
  CHECK(pose_complaint(header + ",v_RS_R_x [m s^-1]\n1403636580838555648,4,1,0,1,0,0,0,0.1\n")
            .find(told) == 0);
}
