// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam/place.hpp>

#include "adaptors/small_host.hpp"
#include "catch.hpp"

using namespace topobag;
using small_host::KeyFrame;

TEST_CASE("verified places go before the host's candidates, guesses after", "[adaptors]") {
  const Eigen::Isometry3d anywhere = Eigen::Isometry3d::Identity();
  KeyFrame a(1, 0.0, anywhere), b(2, 0.0, anywhere), c(3, 0.0, anywhere), d(4, 0.0, anywhere);
  const auto place = [](KeyFrame& key_frame, bool verified) {
    OrbSlamPlace<KeyFrame> made;
    made.key_frame = &key_frame;
    made.verified = verified;
    return made;
  };
  const std::vector<OrbSlamPlace<KeyFrame>> places{place(a, true), place(a, false), place(b, false),
                                                   place(d, false)};
  KeyFrame bad(5, 0.0, anywhere);
  bad.SetBadFlag();
  using Pointers = std::vector<KeyFrame*>;
  CHECK(merge_candidates(places, Pointers{&c, &bad, &b, nullptr, &c}) == Pointers{&a, &c, &b, &d});
  CHECK(merge_candidates<KeyFrame>({}, {}).empty());
}

TEST_CASE("a place's camera pose takes the world to the camera", "[adaptors]") {
  OrbSlamPlace<KeyFrame> place;
  place.T_world_query.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // a quarter turn about z
  place.T_world_query.translation() = Eigen::Vector3d(1, 2, 3);
  CHECK(place.camera_pose() == PlainPose{0, 1, 0, -2, -1, 0, 0, 1, 0, 0, 1, -3, 0, 0, 0, 1});
}

TEST_CASE("a place is where the pose in the candidate puts the camera", "[adaptors]") {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    KeyFrame key_frame(1, 0.0, random_camera(random));
    CandidateReport report;
    report.pose.emplace();
    report.pose->T_candidate_query = random_camera(random);
    report.pose->scale = 0.7;
    report.other_poses.emplace_back();
    report.other_poses[0].T_candidate_query = random_camera(random);
    report.verdict = Verdict::accepted;
    std::vector<OrbSlamPlace<KeyFrame>> places;
    detail::append_places(report, &key_frame, nullptr, places);
    REQUIRE(places.size() == 2);
    const Eigen::Isometry3d T_world_candidate = host_pose(key_frame.GetPoseInverse());
    for (const auto& place : places) {
      CHECK(place.key_frame == &key_frame);
      CHECK(place.T_world_query.isApprox(T_world_candidate * place.T_candidate_query));
    }
    CHECK(places[0].T_candidate_query.isApprox(report.pose->T_candidate_query));
    CHECK(places[0].scale == 0.7);
    CHECK(places[1].scale == 1.0);
    CHECK(places[0].verified);
    CHECK_FALSE(places[1].verified);  // the decision is about the best pose
  }
}

TEST_CASE("verified places come before guesses of a better score", "[adaptors]") {
  std::vector<OrbSlamPlace<KeyFrame>> places(4);
  const double scores[] = {3.0, 1.0, 9.0, 2.0};
  for (std::size_t i = 0; i < 4; ++i) {
    places[i].score = scores[i];
    places[i].verified = i < 2;
  }
  std::vector<double> sorted;
  for (const auto& place : detail::best_first(places)) sorted.push_back(place.score);
  CHECK(sorted == std::vector<double>{3.0, 1.0, 9.0, 2.0});
  std::reverse(places.begin(), places.end());
  sorted.clear();
  for (const auto& place : detail::best_first(places)) sorted.push_back(place.score);
  CHECK(sorted == std::vector<double>{3.0, 1.0, 9.0, 2.0});
}
