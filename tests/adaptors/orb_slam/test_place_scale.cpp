// SPDX-License-Identifier: MIT
// Maps in units of their own beside a host that does not know its scale.
#include <cstddef>
#include <random>
#include <utility>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/graph/scaled_graph.hpp>
#include <topobag/matching/scale_range.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

OrbSlamOptions of_unknown_scale() {
  OrbSlamOptions options = atlas_host::single_frames();
  options.recognition.matching.scale = ScaleRange{};
  return options;
}

/// A key frame of a map whose unit is 1 / `per_metre` m: its pose and what it shows are in that.
atlas_host::KeyFrame& mapped_in_units(atlas_host::Session& session, double stamp,
                                      atlas_host::Map& map, double per_metre) {
  atlas_host::KeyFrame& key_frame = session.made(stamp, map);
  const TopologyGraph<> seen = session.room.seen_from(key_frame.T_world_camera);
  KeyframeSighting sighting;
  sighting.stamp = stamp;
  sighting.nodes = scaled(seen, per_metre).nodes();
  key_frame.T_world_camera.translation() *= per_metre;
  session.database.observe(session.database.epoch(), key_frame.mnId, std::move(sighting));
  session.database.add(&key_frame);
  return key_frame;
}

}  // namespace

TEST_CASE("a place in a map of another unit says how the units go together", "[adaptors]") {
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    for (const double per_metre : {0.7, 1.6}) {
      CAPTURE(seed, per_metre);
      atlas_host::Session session(seed, of_unknown_scale());
      const atlas_host::KeyFrame& sought = session.mapped(0.0, session.first);
      atlas_host::KeyFrame& now = mapped_in_units(session, 50.0, session.second, per_metre);
      const auto places = session.database.merge_places(&now);
      if (places.empty()) continue;
      ++found;
      const auto& place = places.front();
      CHECK(place.key_frame == &sought);
      CHECK(place.other_map);
      CHECK(place.scale == Approx(1.0 / per_metre).epsilon(0.03));
      Eigen::Isometry3d T_room_camera = now.T_world_camera;
      T_room_camera.translation() /= per_metre;
      const TopologyGraph<> seen = session.room.seen_from(T_room_camera);
      for (const auto& node : seen.nodes()) {
        const Eigen::Vector3d seen_in_units = per_metre * *node.position;
        const Eigen::Vector3d at = place.T_world_query * (place.scale * seen_in_units);
        CHECK((at - T_room_camera * *node.position).norm() < 0.15);
      }
    }
  }
  CHECK(found >= 16);
}

TEST_CASE("where the scale is known a place has scale one", "[adaptors]") {
  atlas_host::Session session(3);
  session.mapped(0.0, session.first);
  atlas_host::KeyFrame& now = session.mapped(50.0, session.second);
  const auto places = session.database.merge_places(&now);
  REQUIRE_FALSE(places.empty());
  CHECK(places.front().scale == 1.0);
}
