// SPDX-License-Identifier: MIT
#include "rotation_reading.hpp"

#include <map>
#include <random>
#include <string>

#include "catch.hpp"
#include "error_text.hpp"
#include "run_program.hpp"

namespace {

using Scores = std::map<int, topobag::SequenceScore>;

Eigen::Quaterniond drawn_rotation(std::mt19937& random, double spread) {
  std::normal_distribution<double> normal(0.0, spread);
  return Eigen::Quaterniond(1.0, normal(random), normal(random), normal(random)).normalized();
}

/// 60 matched poses, the estimate's in a world of its own and a degree or two off.
Scores drawn_rotations(std::uint32_t seed) {
  std::mt19937 random(seed);
  const Eigen::Quaterniond world = drawn_rotation(random, 2.0);
  Scores scores;
  for (int i = 0; i < 60; ++i) {
    topobag::PosePair pair;
    const Eigen::Quaterniond truth = drawn_rotation(random, 1.0);
    pair.T_true = Eigen::Isometry3d(truth);
    pair.T_estimate = Eigen::Isometry3d(world * truth * drawn_rotation(random, 0.01));
    scores[1].pairs.push_back(pair);
  }
  return scores;
}

Eigen::Isometry3d with_w_misread(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return Eigen::Isometry3d(Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()));
}

std::string said_of_rotations(const Scores& scores) {
  return error_text([&] { program::require_same_rotations("truth", "estimate", scores); });
}

}  // namespace

TEST_CASE("rotations that only go together read otherwise are refused", "[examples][regression]") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Scores right = drawn_rotations(seed);
    CHECK(said_of_rotations(right) == "nothing was thrown");
    Scores scores = right;
    for (auto& pair : scores[1].pairs) pair.T_estimate = with_w_misread(pair.T_estimate);
    CHECK(said_of_rotations(scores).find("estimate: its rotations do not go with") == 0);
    CHECK(said_of_rotations(scores).find("w first; write it with w last") != std::string::npos);
    scores = right;
    for (auto& pair : scores[1].pairs) pair.T_true = with_w_misread(pair.T_true);
    CHECK(said_of_rotations(scores).find("truth: its rotations do not go with") == 0);
    scores = right;
    for (auto& pair : scores[1].pairs) pair.T_estimate = pair.T_estimate.inverse();
    CHECK(said_of_rotations(scores).find("when it is read as world to camera; one of the two "
                                         "holds the inverse") != std::string::npos);
    scores = right;  // a bad estimate is bad however it is read
    std::mt19937 random(seed);
    for (auto& pair : scores[1].pairs) {
      pair.T_estimate = Eigen::Isometry3d(drawn_rotation(random, 1.0));
    }
    CHECK(said_of_rotations(scores) == "nothing was thrown");
  }
}

TEST_CASE("topobag trajectory: a quaternion with w first is refused", "[program][regression]") {
  const ScratchFolder folder;
  std::mt19937 random(1);
  std::string last, first;
  for (int i = 0; i < 60; ++i) {
    const Eigen::Quaterniond q = drawn_rotation(random, 1.0);
    const std::string at = std::to_string(i) + ' ' + std::to_string(0.1 * i) + " 0 0 ";
    const auto text = [](double x) { return std::to_string(x) + ' '; };
    last += at + text(q.x()) + text(q.y()) + text(q.z()) + text(q.w()) + '\n';
    first += at + text(q.w()) + text(q.x()) + text(q.y()) + text(q.z()) + '\n';
  }
  folder.write("last.txt", last);
  folder.write("first.txt", first);
  const std::string command = "trajectory --groundtruth " + folder.path("last.txt");
  CHECK(refusal(command + " --estimate " + folder.path("first.txt"))
            .find(folder.path("first.txt") + ": its rotations do not go with") == 0);
  const ProgramRun itself = run_program(command + " --estimate " + folder.path("last.txt"));
  CHECK(itself.exit_code == 0);
  CHECK(itself.err == "topobag: " + folder.path("last.txt") + ": it is the ground truth itself\n");
}
