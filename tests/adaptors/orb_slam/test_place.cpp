// SPDX-License-Identifier: MIT
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
