// SPDX-License-Identifier: MIT
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include <topobag/adaptors/orb_slam/host_state.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;
using HostFrame = atlas_host::KeyFrame;

TEST_CASE("a key frame's state is what the host says at that moment", "[adaptors]") {
  atlas_host::Map map;
  const Eigen::Isometry3d pose(Eigen::Translation3d(1.0, 2.0, 3.0));
  HostFrame key_frame{1, 0.0, pose, &map};
  const GravityOfHost<HostFrame> down = [](HostFrame&) {
    return Gravity<>{Eigen::Vector3d::UnitY(), 0.02};
  };
  const HostKeyFrameState state = host_state(key_frame, down);
  CHECK(state.is_readable);
  CHECK_FALSE(state.is_bad);
  CHECK(state.map == &map);
  CHECK(state.T_world_camera.isApprox(pose, 1e-6));
  CHECK(state.gravity->down == Eigen::Vector3d::UnitY());
  CHECK_FALSE(host_state(key_frame, GravityOfHost<HostFrame>{}).gravity);
  key_frame.bad = true;
  CHECK(host_state(key_frame, down).is_bad);
}

TEST_CASE("what goes wrong in the host leaves a state that is not readable", "[adaptors]") {
  atlas_host::Map map;
  HostFrame key_frame{1, 0.0, Eigen::Isometry3d::Identity(), &map};
  const GravityOfHost<HostFrame> fails = [](HostFrame&) -> std::optional<Gravity<>> {
    throw std::runtime_error("no IMU");
  };
  CHECK_FALSE(host_state(key_frame, fails).is_readable);
  key_frame.T_world_camera.translation().x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(host_state(key_frame, GravityOfHost<HostFrame>{}).is_readable);
}

TEST_CASE("key frames join a graph of their own map, while they are good", "[adaptors]") {
  atlas_host::Map here, elsewhere;
  const auto state_of = [](atlas_host::Map& map, bool bad) {
    HostFrame key_frame{1, 0.0, Eigen::Isometry3d::Identity(), &map, bad};
    return host_state(key_frame, GravityOfHost<HostFrame>{});
  };
  const HostKeyFrameState own = state_of(here, false);
  CHECK(state_of(here, false).joins(own));
  CHECK_FALSE(state_of(here, true).joins(own));
  CHECK_FALSE(state_of(elsewhere, false).joins(own));
}

TEST_CASE("a window is read of the last one's map, the last one itself always", "[adaptors]") {
  atlas_host::Map here, elsewhere;
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  HostFrame other{0, 0.0, origin, &elsewhere}, culled{1, 1.0, origin, &here, true};
  HostFrame good{2, 2.0, Eigen::Isometry3d(Eigen::Translation3d(2.0, 0.0, 0.0)), &here};
  HostFrame own{3, 3.0, origin, &here, true};
  std::vector<SightedKeyFrame<HostFrame>> members;
  for (HostFrame* key_frame : {&other, &culled, &good, &own}) {
    members.push_back({key_frame->mnId, std::make_shared<KeyframeSighting>(), key_frame});
  }
  std::vector<PosedSighting> posed;
  FusedWindow window;
  read_window(members, GravityOfHost<HostFrame>{}, posed, window);
  REQUIRE(posed.size() == 2);
  CHECK(posed[0].sighting == members[2].sighting);
  CHECK(posed[0].T_world_camera.translation().x() == Approx(2.0));
  CHECK(posed[1].sighting == members[3].sighting);
  FusedWindow expected;
  expected.add(2, posed[0].T_world_camera, {});
  expected.add(3, posed[1].T_world_camera, {});
  CHECK_FALSE(window.differs_from(expected, {}));
}
