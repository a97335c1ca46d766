// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <topobag/adaptors/orb_slam/key_frame_register.hpp>

#include "adaptors/small_host.hpp"
#include "catch.hpp"

using namespace topobag;
using small_host::KeyFrame;

namespace {

KeyframeSighting at(double stamp) {
  KeyframeSighting sighting;
  sighting.stamp = stamp;
  return sighting;
}

}  // namespace

TEST_CASE("a window holds the sighted and registered key frames before", "[adaptors]") {
  const Eigen::Isometry3d anywhere = Eigen::Isometry3d::Identity();
  KeyFrame a(1, 0.0, anywhere), b(2, 2.0, anywhere), c(3, 3.0, anywhere), d(4, 4.0, anywhere);
  KeyFrameRegister<KeyFrame> known;
  for (KeyFrame* key_frame : {&d, &a, &b}) known.add(key_frame->mnId, key_frame);
  for (const auto& [id, stamp] : {std::pair{1U, 0.0}, {3U, 3.0}, {2U, 2.0}, {4U, 4.0}}) {
    CHECK(known.observe(0, id, at(stamp)));
  }
  // c is not registered, a too old, d later.
  const auto window = known.window_of(3, &c, 2.5);
  REQUIRE(window.size() == 2);
  CHECK(window[0].key_frame == &b);
  CHECK(window[1].key_frame == &c);
  CHECK(known.window_of(3, &c, 3.0).size() == 3);
  CHECK(known.window_of(3, &c, 3.0)[0].key_frame == &a);
  CHECK(known.window_of(9, &c, 3.0).empty());
}

TEST_CASE("culled key frames stay culled until the epoch ends", "[adaptors]") {
  KeyFrame a(1, 0.0, Eigen::Isometry3d::Identity());
  KeyFrameRegister<KeyFrame> known;
  known.erase(1);
  CHECK_FALSE(known.add(1, &a));
  CHECK_FALSE(known.observe(0, 1, at(0.0)));
  known.clear();
  CHECK(known.epoch() == 1);
  CHECK_FALSE(known.observe(0, 1, at(0.0)));
  CHECK(known.add(1, &a));
  CHECK(known.observe(1, 1, at(0.0)));
  CHECK(known.key_frame(1) == &a);
  CHECK(known.is_sighted(1));
  known.erase(1);
  CHECK(known.key_frame(1) == nullptr);
  CHECK_FALSE(known.is_sighted(1));
}

TEST_CASE("what is given up need not be waited for, and may come after all", "[adaptors]") {
  KeyFrameRegister<KeyFrame> known;
  CHECK_FALSE(known.is_settled(1));
  known.give_up(1, 1);  // of another epoch
  CHECK_FALSE(known.is_settled(1));
  known.give_up(0, 1);
  CHECK(known.is_settled(1));
  CHECK_FALSE(known.is_sighted(1));
  CHECK(known.observe(0, 1, at(0.0)));
  CHECK(known.is_sighted(1));
  known.erase(2);
  CHECK(known.is_settled(2));
  known.clear();
  CHECK_FALSE(known.is_settled(1));
}

TEST_CASE("a window is the same whatever was sighted twice or culled", "[adaptors]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> seconds(0.0, 20.0);
  std::vector<std::unique_ptr<KeyFrame>> key_frames;
  std::map<std::uint64_t, double> stamps;
  KeyFrameRegister<KeyFrame> known;
  for (std::uint64_t id = 0; id < 200; ++id) {
    key_frames.push_back(std::make_unique<KeyFrame>(id, 0.0, Eigen::Isometry3d::Identity()));
    known.add(id, key_frames.back().get());
  }
  for (int i = 0; i < 500; ++i) {
    const std::uint64_t id = random() % 200;
    if (i % 50 == 0) {
      known.erase(id);
      stamps.erase(id);
    } else if (const double stamp = std::round(seconds(random)); known.observe(0, id, at(stamp))) {
      stamps[id] = stamp;
    }
  }
  for (const auto& [id, stamp] : stamps) {
    std::set<std::pair<double, std::uint64_t>> expected;
    for (const auto& [other, earlier] : stamps) {
      if (other != id && earlier <= stamp && stamp - earlier <= 3.0) expected.insert({earlier, other});
    }
    const auto window = known.window_of(id, key_frames[id].get(), 3.0);
    REQUIRE(window.size() == expected.size() + 1);
    auto next = window.begin();
    for (const auto& member : expected) CHECK((next++)->key_frame->mnId == member.second);
    CHECK(next->key_frame->mnId == id);
  }
}
