// SPDX-License-Identifier: MIT
#include <optional>
#include <random>
#include <vector>

#include <topobag/recognition/temporal_consistency.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

using Pose = Eigen::Isometry3d;

Recognition match(unsigned id, const Pose& T = Pose::Identity()) {
  Recognition recognition;
  recognition.accepted.emplace();
  recognition.accepted->id = KeyframeId{id};
  recognition.accepted->pose.emplace().T_candidate_query = T;
  return recognition;
}

/// A camera that goes through a mapped world, and a match of each of its key frames with a key
/// frame of the map.
struct Walk {
  explicit Walk(unsigned seed) {
    std::mt19937 random(seed);
    Pose T_world_camera = random_motion(random, 2.0);
    for (unsigned i = 0; i < 8; ++i) {
      const Pose step = random_motion(random, 0.5);
      T_world_camera = T_world_camera * step;
      T_previous_current.push_back(step);
      T_world_candidate.push_back(random_motion(random, 2.0));
      matches.push_back(match(i, T_world_candidate.back().inverse() * T_world_camera));
    }
  }

  bool add(TemporalConsistency& policy, std::size_t i) const {
    return policy.add(matches[i], T_previous_current[i], T_world_candidate[i]);
  }

  std::vector<Pose> T_previous_current, T_world_candidate;
  std::vector<Recognition> matches;
};

}  // namespace

TEST_CASE("matches that move with the camera are believed from the third on", "[recognition]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Walk walk(seed);
    TemporalConsistency policy;
    for (std::size_t i = 0; i < walk.matches.size(); ++i) {
      CHECK(walk.add(policy, i) == (i >= 2));
      CHECK(policy.matches() == i + 1);
    }
  }
}

TEST_CASE("a match that jumps starts again", "[recognition]") {
  Walk walk(1);
  walk.matches[3].accepted->pose->T_candidate_query.translation().x() += 1.0;
  TemporalConsistency policy;
  const std::vector<std::size_t> expected{1, 2, 3, 1, 1, 2, 3, 4};
  for (std::size_t i = 0; i < walk.matches.size(); ++i) {
    walk.add(policy, i);
    CHECK(policy.matches() == expected[i]);
  }
}

TEST_CASE("a rotation that jumps starts again, too", "[recognition]") {
  Walk walk(2);
  Pose& T = walk.matches[1].accepted->pose->T_candidate_query;
  T = T * Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitY());
  TemporalConsistency policy;
  walk.add(policy, 0);
  walk.add(policy, 1);
  CHECK(policy.matches() == 1);
}

TEST_CASE("one key frame without a match is borne, and its motion counts", "[recognition]") {
  const Walk walk(3);
  TemporalConsistency policy;
  walk.add(policy, 0);
  walk.add(policy, 1);
  CHECK_FALSE(policy.add(Recognition{}, walk.T_previous_current[2]));
  CHECK(walk.add(policy, 3));
  CHECK(policy.matches() == 3);
  policy.add(Recognition{}, walk.T_previous_current[4]);
  policy.add(Recognition{}, walk.T_previous_current[5]);
  CHECK(policy.matches() == 0);
  CHECK_FALSE(walk.add(policy, 6));
  CHECK(policy.matches() == 1);
}

TEST_CASE("in one key frame of the map no pose of it is needed", "[recognition]") {
  std::mt19937 random(4);
  const Pose step = random_motion(random, 0.3), first = random_motion(random, 1.0);
  TemporalConsistency policy;
  policy.add(match(7, first));
  policy.add(match(7, first * step), step);
  CHECK(policy.matches() == 2);
  policy.add(match(7, Pose(Eigen::Translation3d(9, 9, 9)) * first), step);
  CHECK(policy.matches() == 1);
}

TEST_CASE("without motion, candidates have to be of one place", "[recognition]") {
  const auto near = [](KeyframeId a, KeyframeId b) {
    return value(a) + 3 > value(b) && value(b) + 3 > value(a);
  };
  TemporalConsistency policy({}, near);
  policy.add(match(10));
  policy.add(match(12));
  CHECK(policy.add(match(11)));
  CHECK_FALSE(policy.add(match(20)));
  CHECK(policy.matches() == 1);

  TemporalConsistency strict;
  strict.add(match(10));
  strict.add(match(11));
  CHECK(strict.matches() == 1);
  strict.add(match(11));
  CHECK(strict.matches() == 2);
}

TEST_CASE("the policy's numbers are options, and it forgets when told", "[recognition]") {
  TemporalOptions options;
  options.min_matches = 1;
  options.max_missed = 0;
  TemporalConsistency policy(options);
  CHECK(policy.add(match(1)));
  policy.add(Recognition{});
  CHECK(policy.matches() == 0);
  policy.add(match(1));
  policy.reset();
  CHECK(policy.matches() == 0);
}

TEST_CASE("a pose that is none is refused and changes nothing", "[recognition][regression]") {
  TemporalConsistency policy;
  policy.add(match(1));
  Pose scaled = Pose::Identity();
  scaled.linear() *= 2.0;
  CHECK_THROWS_AS(policy.add(match(1), scaled), InvalidValue);
  CHECK_THROWS_AS(policy.add(match(1), Pose::Identity(), scaled), InvalidValue);
  CHECK(policy.matches() == 1);
}
