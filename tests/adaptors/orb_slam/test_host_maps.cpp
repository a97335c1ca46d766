// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

using atlas_host::Database;
using atlas_host::Frame;
using atlas_host::Map;
using atlas_host::Pointers;
using MappedKeyFrame = atlas_host::KeyFrame;

}  // namespace

static_assert(has_maps_v<MappedKeyFrame>);
static_assert(!has_maps_v<small_host::KeyFrame>);

TEST_CASE("a key frame in a bad map is of no use", "[adaptors]") {
  Map map;
  MappedKeyFrame key_frame{1, 0.0, Eigen::Isometry3d::Identity(), &map};
  CHECK_FALSE(is_bad(key_frame));
  map.bad = true;
  CHECK(is_bad(key_frame));
  CHECK(map_of(key_frame) == &map);
}

TEST_CASE("a graph is fused within one map alone", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  Map here, elsewhere;
  MappedKeyFrame before{1, 0.0, origin, &elsewhere}, now{2, 1.0, origin, &here};
  KeyFrameBag<MappedKeyFrame> bag({}, {});
  KeyframeSighting seen_before = small_host::sighting(room, before.mTimeStamp, origin);
  KeyframeSighting seen_now = small_host::sighting(room, now.mTimeStamp, origin);
  const std::size_t all = seen_now.nodes.size();
  seen_now.nodes.resize(4);
  bag.add(&before);
  bag.add(&now);
  bag.observe(0, before.mnId, seen_before);
  bag.observe(0, now.mnId, seen_now);
  const std::chrono::milliseconds at_once(0);
  CHECK(bag.graph_of(&now, at_once)->size() == 4);
  before.map = &here;  // the maps were merged
  CHECK(bag.graph_of(&now, at_once)->size() == all);
}

TEST_CASE("with several maps candidates are told apart by map", "[adaptors]") {
  const SyntheticRoom room(7, 9, 4);
  std::mt19937 random(2);
  Map here, elsewhere;
  Database database({}, [&](const Frame& frame) {
    return std::optional<TopologyGraph<>>(room.seen_from(frame.T_world_camera));
  });
  std::vector<std::unique_ptr<MappedKeyFrame>> key_frames;
  const auto mapped = [&](double stamp, Map& map) -> MappedKeyFrame& {
    const auto id = static_cast<unsigned long>(key_frames.size());
    key_frames.push_back(
        std::make_unique<MappedKeyFrame>(MappedKeyFrame{id, stamp, random_camera(random), &map}));
    MappedKeyFrame& key_frame = *key_frames.back();
    database.observe(0, id, small_host::sighting(room, stamp, key_frame.T_world_camera));
    database.add(&key_frame);
    return key_frame;
  };
  MappedKeyFrame& same = mapped(0.0, here);
  MappedKeyFrame& other = mapped(10.0, elsewhere);
  MappedKeyFrame& now = mapped(100.0, here);

  Pointers loops{&same}, merges;
  database.DetectNBestCandidates(&now, loops, merges, 3);
  CHECK(loops == Pointers{&same});
  CHECK(merges == Pointers{&other});
  Pointers no_loops, no_merges;
  database.DetectNBestCandidates(&now, no_loops, no_merges, 0);
  CHECK(no_loops.empty());

  Frame frame{random_camera(random)};
  const Pointers found = database.DetectRelocalizationCandidates(&frame, &elsewhere);
  CHECK(found == Pointers{&other});
  database.clearMap(&elsewhere);
  CHECK(database.size() == 2);
  CHECK(database.DetectRelocalizationCandidates(&frame, &elsewhere).empty());
  here.bad = true;
  CHECK(database.DetectRelocalizationCandidates(&frame, &here).empty());
}
