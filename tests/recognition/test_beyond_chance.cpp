// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>

#include <topobag/recognition/certain_negatives.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

TEST_CASE("a match is beyond chance where a decision at its defaults asks for no more",
          "[recognition]") {
  // A hundred rooms 20 m apart; what is asked goes by how many of them hold such objects, and by
  // whether anything could be missing.
  std::mt19937 random(9);
  std::size_t beyond = 0, all = 0;
  for (const bool with_views : {false, true}) {
    Relocalizer<> map;
    for (unsigned i = 0; i < 100; ++i) {
      const Eigen::Isometry3d T_room_camera = random_camera(random);
      const TopologyGraph<> seen =
          SyntheticRoom(i / 2, 5, i % 10 == 0 ? 9 : 3).seen_from(T_room_camera);
      map.map().add(KeyframeId{i}, seen,
                    standing_at(Eigen::Translation3d(20.0 * i, 0.0, 0.0) * T_room_camera));
    }
    for (unsigned i = 0; i < 60; ++i) {
      const TopologyGraph<> seen =
          SyntheticRoom(i, 5, i % 10 == 0 ? 9 : 3).seen_from(random_camera(random));
      View<> view;
      view.camera = {525, 525, 320, 240, 640, 480};
      const TopologyGraph<> query = with_views ? TopologyGraph<>(seen.nodes(), {}, {view}) : seen;
      const Recognition decided = map.localize(query);
      for (const CandidateReport& open :
           map.localize(query, without_threshold(map.options())).candidates) {
        for (const CandidateReport& report : decided.candidates) {
          if (report.id != open.id || report.score() != open.score()) continue;
          CHECK(open.with_views == with_views);
          CHECK(is_beyond_chance(open) == (report.pose && report.margin() >= 0.0));
          ++all;
          if (is_beyond_chance(open)) ++beyond;
        }
      }
    }
  }
  CHECK(beyond > 20);
  CHECK(all - beyond > 20);
}

TEST_CASE("what is beyond chance is told by the places of the matched objects, and by views",
          "[recognition][regression]") {
  CandidateReport report;
  report.pose.emplace();
  report.place_share = 1.0;
  const auto beyond = [&](double score, std::size_t places, bool with_views) {
    report.place_support = score - report.pose->viewpoint_odds;
    report.places = places;
    report.with_views = with_views;
    return is_beyond_chance(report);
  };
  CHECK_FALSE(beyond(4.2, 100, false));  // log10(100 / 0.001) - 0.5
  CHECK(beyond(4.51, 100, false));
  CHECK(beyond(4.2, 100, true));
  CHECK(beyond(3.03, 6, true));  // objects of one place, and five more to be on the safe side
  report.pose.reset();
  CHECK_FALSE(is_beyond_chance(report));
}
