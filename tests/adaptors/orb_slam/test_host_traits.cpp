// SPDX-License-Identifier: MIT
#include <chrono>
#include <memory>
#include <optional>
#include <random>
#include <type_traits>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>

#include "adaptors/small_host.hpp"
#include "adaptors/stella_host.hpp"
#include "catch.hpp"

using namespace topobag;
using stella_host::keyframe;

namespace {

using StellaDatabase = OrbSlamDatabase<keyframe, stella_host::frame, stella_host::map_database>;
using Shared = std::vector<std::shared_ptr<keyframe>>;

struct StellaHost {
  SyntheticRoom room{7, 9, 4};
  std::mt19937 random{3};
  StellaDatabase database{single(), [this](const stella_host::frame& frame) {
                            return std::optional(room.seen_from(frame.T_world_camera));
                          }};

  static OrbSlamOptions single() {
    OrbSlamOptions options;
    options.loop_wait = std::chrono::milliseconds(0);
    options.fusing.window = 0.0;
    return options;
  }
  std::shared_ptr<keyframe> mapped(unsigned int id, double stamp) {
    const Eigen::Isometry3d T = random_camera(random);
    auto key_frame = std::make_shared<keyframe>(id, stamp, T);
    database.observe(database.epoch(), id, small_host::sighting(room, stamp, T));
    database.add(key_frame);
    return key_frame;
  }
};

}  // namespace

static_assert(is_host_key_frame_v<keyframe> && !has_maps_v<keyframe>);
static_assert(std::is_same_v<host_pointer_t<keyframe>, std::shared_ptr<keyframe>>);
static_assert(std::is_same_v<host_pointer_t<small_host::KeyFrame>, small_host::KeyFrame*>);

TEST_CASE("a host with shared pointers and names of its own", "[adaptors]") {
  StellaHost host;
  const auto old = host.mapped(1, 0.0), covisible = host.mapped(2, 50.0),
             culled = host.mapped(3, 60.0), now = host.mapped(4, 100.0);
  now->graph_node_->connected_ = {covisible};
  culled->will_be_erased_ = true;
  CHECK(host.database.DetectLoopCandidates(now, 0.0F) == Shared{old});

  stella_host::frame lost{random_camera(host.random)};
  const auto places = host.database.relocalization_places(lost);
  REQUIRE_FALSE(places.empty());
  CHECK(places.front().verified);
  CHECK((places.front().T_world_query.inverse() * lost.T_world_camera).translation().norm() < 1e-3);

  host.database.erase(old);
  CHECK(host.database.DetectLoopCandidates(now, 0.0F, {culled, covisible}) == Shared{covisible});
  CHECK(host.database.failures().first == 0);
}

TEST_CASE("the host's key frames are let go of when they are erased", "[adaptors]") {
  StellaHost host;
  std::weak_ptr<keyframe> erased, cleared;
  {
    const auto first = host.mapped(1, 0.0), second = host.mapped(2, 50.0);
    erased = first;
    cleared = second;
    host.database.erase(first);
  }
  CHECK(erased.expired());
  CHECK_FALSE(cleared.expired());
  host.database.clear();
  CHECK(cleared.expired());
}

TEST_CASE("ids that the host moved up on loading find their sightings", "[adaptors]") {
  StellaHost before, after;
  const auto first = before.mapped(1, 0.0), second = before.mapped(2, 50.0);
  after.mapped(1, 10.0);
  const auto loaded = std::make_shared<keyframe>(101, 0.0, Eigen::Isometry3d(first->pose_wc_));
  after.database.add(loaded);
  CHECK(after.database.size() == 1);
  CHECK(after.database.restore(before.database.sightings(), 100) == 2);
  CHECK(after.database.size() == 2);
  after.database.add(std::make_shared<keyframe>(102, 50.0, Eigen::Isometry3d(second->pose_wc_)));
  CHECK(after.database.size() == 3);
}
