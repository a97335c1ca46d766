// SPDX-License-Identifier: MIT
#include <limits>

#include <topobag/evaluation/relative_pose_error.hpp>

#include "catch.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;
using topobag_tests::planar_pose;
using Unit = RelativeStep::Unit;

namespace {

/// A straight drive of 1 m and 0.5 s a pose whose estimate is 10 % too long and turns by 1° a pose.
std::vector<PosePair> drive(int n) {
  std::vector<PosePair> pairs;
  Eigen::Isometry3d estimate = planar_pose(7, 7, 50);
  for (int i = 0; i < n; ++i) {
    pairs.push_back({0.5 * i, planar_pose(i, 0, 0), estimate});
    estimate = estimate * planar_pose(1.1, 0, 1);
  }
  return pairs;
}

}  // namespace

TEST_CASE("a constant drift is the error of every step", "[evaluation]") {
  for (const Unit unit : {Unit::frames, Unit::seconds, Unit::metres}) {
    RelativeStep step{unit, unit == Unit::seconds ? 0.5 : 1.0};
    const auto errors = relative_pose_errors(drive(11), step);
    CHECK(errors.size() == 10);
    for (const PoseError& error : errors) {
      CHECK(error.translation_m == Approx(0.1));
      CHECK(error.rotation_deg == Approx(1.0));
    }
  }
}

TEST_CASE("longer steps, from every pose or end to end", "[evaluation]") {
  RelativeStep step{Unit::frames, 3.0};
  CHECK(relative_pose_errors(drive(11), step).size() == 8);
  step.all_starts = false;
  const auto errors = relative_pose_errors(drive(11), step);
  CHECK(errors.size() == 3);
  CHECK(errors[0].rotation_deg == Approx(3.0));
  CHECK(relative_pose_errors(drive(3), step).empty());
  CHECK(relative_pose_errors({}, step).empty());
}

TEST_CASE("a step that no pose ends within the tolerance is left out", "[evaluation]") {
  auto pairs = drive(6);
  pairs[3].stamp = 1.56;  // instead of 1.5
  CHECK(relative_pose_errors(pairs, {Unit::seconds, 0.5, 0.1, true}).size() == 3);
  CHECK(relative_pose_errors(pairs, {Unit::seconds, 0.5, 0.13, true}).size() == 5);
}

TEST_CASE("the end of a step is the nearest pose, found by trying all", "[evaluation]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.01, 1.0);
  for (int round = 0; round < 200; ++round) {
    std::vector<PosePair> pairs;
    double t = 0.0;
    for (int i = 0; i < 30; ++i) {
      pairs.push_back({t += unit(random), topobag_tests::random_pose(random),
                       topobag_tests::random_pose(random)});
    }
    const RelativeStep step{Unit::seconds, 2.0, 0.2, true};
    std::vector<double> expected;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      std::size_t best = i;
      double miss = std::numeric_limits<double>::infinity();
      for (std::size_t j = i + 1; j < pairs.size(); ++j) {
        const double m = std::abs(pairs[j].stamp - (pairs[i].stamp + 2.0));
        if (m < miss) {
          miss = m;
          best = j;
        }
      }
      if (best == i || miss > 0.4) continue;
      const Eigen::Isometry3d Q = pairs[i].T_true.inverse() * pairs[best].T_true;
      const Eigen::Isometry3d P = pairs[i].T_estimate.inverse() * pairs[best].T_estimate;
      expected.push_back((Q.inverse() * P).translation().norm());
    }
    const auto errors = relative_pose_errors(pairs, step);
    REQUIRE(errors.size() == expected.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
      CHECK(errors[i].translation_m == Approx(expected[i]));
    }
  }
}

TEST_CASE("of two poses as near to the end of a step the earlier ends it", "[evaluation]") {
  auto pairs = drive(3);
  pairs[1].stamp = 0.75;
  pairs[2].stamp = 1.25;
  const auto errors = relative_pose_errors(pairs, {Unit::seconds, 1.0, 0.25, true});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].translation_m == Approx(0.1));
}

TEST_CASE("a step needs a length", "[evaluation]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double length : {0.0, -1.0, nan}) {
    CHECK_THROWS_AS(relative_pose_errors(drive(3), {Unit::frames, length}), InvalidValue);
  }
}
