// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/matching/detail/distinct_poses.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// Poses on a line, 0.1 m apart, with few different scores; some leave the pose open.
std::vector<RelativePose> poses_on_a_line(std::mt19937& random) {
  std::vector<RelativePose> poses(random() % 12);
  for (RelativePose& pose : poses) {
    pose.T_candidate_query = Eigen::Translation3d(0.1 * static_cast<double>(random() % 12), 0, 0);
    pose.significance = static_cast<double>(random() % 5);
    pose.degenerate = random() % 3 == 0;
  }
  return poses;
}

/// By the definition: a better pose, no less determined, is the same.
bool is_told_by(const RelativePose& better, const RelativePose& pose, const MatchOptions& options) {
  const double distance =
      (better.T_candidate_query.translation() - pose.T_candidate_query.translation()).norm();
  return better.score() >= pose.score() && distance <= options.distinct_translation &&
         (pose.degenerate || !better.degenerate);
}

}  // namespace

TEST_CASE("of poses that are the same the best is told, unless it leaves the pose open",
          "[matching]") {
  std::mt19937 random(4);
  MatchOptions options;
  options.distinct_translation = 0.25;
  for (int round = 0; round < 300; ++round) {
    const std::vector<RelativePose> poses = poses_on_a_line(random);
    const std::vector<RelativePose> told = detail::distinct_poses(poses, options);
    REQUIRE(told.empty() == poses.empty());
    CHECK(std::is_sorted(told.begin(), told.end(),
                         [](const auto& a, const auto& b) { return a.score() > b.score(); }));
    for (const RelativePose& pose : poses) {
      CHECK(std::any_of(told.begin(), told.end(), [&](const RelativePose& better) {
        return is_told_by(better, pose, options);
      }));
    }
    for (std::size_t i = 0; i < told.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(is_told_by(told[j], told[i], options));
    }
  }
}

TEST_CASE("a turn tells poses apart as well", "[matching]") {
  MatchOptions options;
  std::vector<RelativePose> poses(2);
  for (const double turn : {0.9, 1.1}) {
    poses[1].T_candidate_query =
        Eigen::AngleAxisd(turn * options.distinct_rotation, Eigen::Vector3d::UnitY());
    CHECK(detail::distinct_poses(poses, options).size() == (turn > 1.0 ? 2 : 1));
  }
}
