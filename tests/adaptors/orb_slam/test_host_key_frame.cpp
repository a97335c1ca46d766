// SPDX-License-Identifier: MIT
#include <set>

#include <topobag/adaptors/orb_slam/host_key_frame.hpp>

#include "adaptors/small_host.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

/// As a host's key frame, but for its pose.
struct NowhereKeyFrame {
  unsigned long mnId = 0;
  double mTimeStamp = 0.0;
  bool isBad() { return false; }
  float GetPoseInverse() { return 0.0F; }
  std::set<NowhereKeyFrame*> GetConnectedKeyFrames() { return {}; }
};

}  // namespace

TEST_CASE("a key frame with ORB-SLAM's names fits", "[adaptors]") {
  CHECK(is_host_key_frame_v<small_host::KeyFrame>);
  CHECK_FALSE(is_host_key_frame_v<NowhereKeyFrame>);
  CHECK_FALSE(is_host_key_frame_v<small_host::Map>);
}
