// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/recognition/calibrate.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;

namespace {

std::size_t verified_places(atlas_host::Session& session, const atlas_host::Map& map) {
  const auto places = session.database.relocalization_places({random_camera(session.random)}, &map);
  return static_cast<std::size_t>(
      std::count_if(places.begin(), places.end(), [](const auto& at) { return at.verified; }));
}

}  // namespace

TEST_CASE("a decision is changed while the host runs", "[adaptors]") {
  atlas_host::Session session(3);
  for (int i = 0; i < 4; ++i) session.mapped(i, session.first);
  RecognitionOptions options = session.database.options();
  CHECK(options.retrieval.max_results == OrbSlamOptions{}.recognition.retrieval.max_results);
  CHECK(verified_places(session, session.first) == 3);
  options.retrieval.max_results = 1;
  session.database.set_options(options);
  CHECK(session.database.options().retrieval.max_results == 1);
  CHECK(verified_places(session, session.first) == 1);
  options.decision.min_score = 1000.0;
  session.database.set_options(options);
  CHECK(verified_places(session, session.first) == 0);
}

TEST_CASE("a calibration that was learnt in a copy of the map says what is asked from then on",
          "[adaptors]") {
  atlas_host::Session session(3);
  for (int i = 0; i < 6; ++i) session.mapped(i, session.first);
  session.mapped(7.0, session.second);
  const Relocalizer<> copy = session.database.copy_of(&session.first);
  std::vector<KeyframeId> ids;
  copy.map().for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>&) {
    CHECK(info.T_world_camera);
    ids.push_back(id);
  });
  CHECK(ids.size() == 6);
  session.database.clear();
  CHECK(copy.localize(session.room.seen_from(random_camera(session.random))));

  RecognitionOptions options = session.database.options();
  CalibrateOptions learning;
  learning.null_queries = 20;
  options.decision.calibration = calibrate(copy, ids, {}, learning);
  CHECK(options.decision.calibration->queries() > 0);
  session.database.set_options(options);
  CHECK(session.database.options().decision.threshold(1000) ==
        options.decision.calibration->threshold(options.decision.false_accept_rate).score);
}

TEST_CASE("a copy is of one map, of the host's only one without saying which", "[adaptors]") {
  atlas_host::Session session(5);
  for (int i = 0; i < 5; ++i) session.mapped(i, i < 2 ? session.first : session.second);
  CHECK(session.database.copy_of(&session.first).map().size() == 2);
  CHECK(session.database.copy_of(&session.second).map().size() == 3);
  CHECK(session.database.copy_of().map().size() == 0);
  KeyFrameBag<small_host::KeyFrame> bag({}, {});
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  small_host::KeyFrame only(1, 0.0, origin);
  bag.observe(0, 1, small_host::sighting(session.room, 0.0, origin));
  bag.add(&only);
  CHECK(bag.copy_of(nullptr).map().size() == 1);
}
