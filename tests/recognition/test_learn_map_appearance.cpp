// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include <topobag/recognition/calibrate.hpp>
#include <topobag/recognition/learn_map_appearance.hpp>

#include "catch.hpp"
#include "recognition/rooms_with_looks.hpp"

using namespace topobag;

namespace {

struct PairCounts {
  std::size_t same = 0, other = 0;
};

/// By the rooms themselves: which entries are of one room, and where their objects are.
PairCounts pairs_by_truth(const RoomsWithLooks& rooms, double min_separation) {
  PairCounts pairs;
  for (std::size_t a = 0; a < rooms.graphs.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const auto &here = rooms.graphs[a].nodes(), &there = rooms.graphs[b].nodes();
      if (a / 2 == b / 2) pairs.same += here.size();
      for (const auto& p : here) {
        for (const auto& q : there) {
          const Eigen::Vector3d apart = *rooms.infos[a].T_world_camera * *p.position -
                                        *rooms.infos[b].T_world_camera * *q.position;
          if (p.label == q.label && apart.norm() > min_separation) ++pairs.other;
        }
      }
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("a map of known poses tells which looks are of one object, and which of two",
          "[recognition][appearance]") {
  const RoomsWithLooks rooms(9);
  const auto relocalizer = rooms.relocalizer();
  MapAppearanceOptions options;
  options.apart.deviations = 0.0;
  std::size_t asked = 0;
  options.on_query = [&] { ++asked; };
  AppearanceCounts counts(relocalizer.map().appearance_kind());
  learn_map_appearance(counts, relocalizer, rooms.ids, options);
  const PairCounts truth = pairs_by_truth(rooms, options.min_separation);
  CHECK(counts.same() == truth.same);
  CHECK(counts.other() == truth.other);
  CHECK(asked == rooms.ids.size());

  const AppearanceModel model = counts.model({0.1, 0.15, 50});
  CHECK(model.kind == rooms.kind);
  CHECK(model.log10_odds(0.95) > 0.6);
  CHECK(model.log10_odds(0.0) < -0.6);
}

TEST_CASE("objects of a class that may be one are not taken for two", "[recognition][appearance]") {
  const RoomsWithLooks rooms(6);
  const auto relocalizer = rooms.relocalizer();
  MapAppearanceOptions far;
  far.min_separation = 5.0;  // m; no room is as large, and the next one is 20 m away
  AppearanceCounts all(rooms.kind), between_rooms(rooms.kind), none(rooms.kind);
  learn_map_appearance(all, relocalizer, rooms.ids);
  learn_map_appearance(between_rooms, relocalizer, rooms.ids, far);
  CHECK(between_rooms.other() < all.other());
  CHECK(between_rooms.other() == pairs_by_truth(rooms, 5.0).other);
  far.min_separation = 500.0;
  learn_map_appearance(none, relocalizer, rooms.ids, far);
  CHECK(none.other() == 0);
  CHECK(none.same() == all.same());
}

TEST_CASE("key frames without poses, and neighbours in time, teach nothing of looks",
          "[recognition][appearance]") {
  RoomsWithLooks rooms(5);
  for (EntryInfo& info : rooms.infos) info.stamp = 1.0;
  AppearanceCounts counts(rooms.kind);
  learn_map_appearance(counts, rooms.relocalizer(), rooms.ids);
  for (EntryInfo& info : rooms.infos) info = {};
  learn_map_appearance(counts, rooms.relocalizer(), rooms.ids);
  CHECK(counts.same() + counts.other() == 0);
}

TEST_CASE("a match that the poses contradict is not one object", "[recognition][appearance]") {
  RoomsWithLooks rooms(5);
  for (std::size_t i = 0; i < rooms.infos.size(); i += 2) {
    *rooms.infos[i].T_world_camera = Eigen::Translation3d(0, 0, 2) * *rooms.infos[i].T_world_camera;
  }
  AppearanceCounts counts(rooms.kind);
  learn_map_appearance(counts, rooms.relocalizer(), rooms.ids);
  CHECK(counts.same() == 0);
}

TEST_CASE("a key frame of elsewhere teaches how alike two objects look",
          "[recognition][appearance]") {
  RoomsWithLooks rooms(4);
  const auto relocalizer = rooms.relocalizer();
  const auto elsewhere = RoomsWithLooks(7).graphs.back();
  AppearanceCounts counts(rooms.kind), expected(rooms.kind);
  learn_elsewhere_appearance(counts, relocalizer, elsewhere);
  for (const auto& graph : rooms.graphs) learn_other_appearance(expected, graph, elsewhere);
  CHECK(counts.other() == expected.other());
  CHECK(counts.same() == 0);
}

TEST_CASE("the scores of a calibration are made with the looks that it keeps",
          "[recognition][appearance]") {
  const RoomsWithLooks rooms(8);
  const auto relocalizer = rooms.relocalizer();
  AppearanceCounts counts(rooms.kind);
  learn_map_appearance(counts, relocalizer, rooms.ids);
  CalibrateOptions options;
  options.null_queries = 30;
  options.appearance = counts.model({0.1, 0.15, 50});
  const Calibration learnt = calibrate(relocalizer, rooms.ids, {}, options);
  REQUIRE(learnt.appearance());
  CHECK(learnt.appearance()->table.size() == options.appearance->table.size());

  RecognitionOptions told;
  told.matching.chance.appearance = *options.appearance;
  options.appearance.reset();
  const Calibration by_hand = calibrate(rooms.relocalizer(told), rooms.ids, {}, options);
  CHECK_FALSE(by_hand.appearance());
  CHECK(learnt.negatives() > 0);
  CHECK(learnt.negative_scores().scores() == by_hand.negative_scores().scores());
  CHECK(learnt.null_scores().scores() == by_hand.null_scores().scores());
  const Calibration blind = calibrate(relocalizer, rooms.ids, {}, options);
  CHECK(blind.negative_scores().scores() != learnt.negative_scores().scores());

  // Calibrated again, with the calibration in place: the same looks, and the same scores.
  RecognitionOptions calibrated;
  calibrated.decision.calibration = learnt;
  const Calibration again = calibrate(rooms.relocalizer(calibrated), rooms.ids, {}, options);
  REQUIRE(again.appearance());
  CHECK(again.negative_scores().scores() == learnt.negative_scores().scores());
  CHECK(again.null_scores().scores() == learnt.null_scores().scores());
}
