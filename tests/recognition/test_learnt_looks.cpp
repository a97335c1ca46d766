// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <random>
#include <string>

#include <topobag/bag/indexed_bag.hpp>
#include <topobag/recognition/calibrate.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/locate_by_bearings.hpp>
#include <topobag/recognition/loop_detector.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "recognition/bearings_of.hpp"
#include "recognition/rooms_with_looks.hpp"

using namespace topobag;

namespace {

/// What looks of a kind say: a made-up table.
AppearanceModel made_up_looks(AppearanceKind kind) {
  AppearanceModel model;
  model.kind = kind;
  model.table = {{0.0, -1.0}, {0.9, 0.7}};
  return model;
}

RecognitionOptions with_learnt_looks(AppearanceKind kind) {
  RecognitionOptions options;
  options.decision.calibration.emplace();
  options.decision.calibration->set_appearance(made_up_looks(kind));
  options.decision.min_score = 3.0;  // whatever the calibration, which learnt no scores
  return options;
}

RecognitionOptions with_told_looks(AppearanceKind kind) {
  RecognitionOptions options;
  options.matching.chance.appearance = made_up_looks(kind);
  options.decision.min_score = 3.0;
  return options;
}

const std::string refused_looks =
    "the calibration learnt looks by descriptors of another kind (8 numbers) than the map's (16 "
    "numbers): calibrate this map anew";

}  // namespace

TEST_CASE("what a calibration learnt of looks is what they are judged by",
          "[recognition][appearance]") {
  RoomsWithLooks rooms(6);
  const RecognitionOptions learnt = with_learnt_looks(rooms.kind),
                           told = with_told_looks(rooms.kind);
  const auto relocalizer = rooms.relocalizer();
  CHECK(appearance_model(learnt).table.size() == 2);
  CHECK(appearance_model({}).kind == ColorDescriptor::kind);
  std::size_t accepted = 0;
  for (unsigned room = 0; room < 6; ++room) {
    const auto query = rooms.seen(room, random_camera(rooms.random));
    const Recognition by_learnt = relocalizer.localize(query, learnt);
    const Recognition by_told = relocalizer.localize(query, told);
    RecognitionOptions silent;
    silent.decision.min_score = 3.0;
    const Recognition without = relocalizer.localize(query, silent);
    REQUIRE(by_learnt.candidates.size() == by_told.candidates.size());
    for (std::size_t i = 0; i < by_told.candidates.size(); ++i) {
      const CandidateReport &a = by_learnt.candidates[i], &b = by_told.candidates[i];
      CHECK(a.id == b.id);
      CHECK(a.verdict == b.verdict);
      if (a.pose && b.pose) CHECK(a.score() == b.score());
    }
    REQUIRE(by_learnt);
    REQUIRE(without);
    CHECK(by_learnt.accepted->score() > without.accepted->score());
    ++accepted;
    const Explanation why =
        explain(by_learnt, relocalizer.map(), query, ClassCatalog::coco80(), learnt);
    REQUIRE(why.candidates.front().matched.size() > 0);
    CHECK(why.candidates.front().matched.front().looks.has_value());
  }
  CHECK(accepted == 6);
}

TEST_CASE("without a threshold looks are judged as the calibration learnt them",
          "[recognition][appearance]") {
  const AppearanceKind kind("made up", 16);
  const RecognitionOptions open = without_threshold(with_learnt_looks(kind));
  CHECK_FALSE(open.decision.calibration);
  CHECK(open.matching.chance.appearance.kind == kind);
  CHECK(without_threshold({}).matching.chance.appearance.kind == ColorDescriptor::kind);
}

TEST_CASE("bearings are judged by the looks that a calibration learnt",
          "[recognition][appearance]") {
  RoomsWithLooks rooms(4);
  const auto relocalizer = rooms.relocalizer();
  const auto seen = rooms.seen(2, random_camera(rooms.random));
  BearingSighting query = bearings_of(seen, rooms.random, 0.005);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    query.bearings[i].appearance = seen.nodes()[i].appearance;
  }
  RecognitionOptions learnt = with_learnt_looks(rooms.kind), told = with_told_looks(rooms.kind);
  const Recognition a = locate_by_bearings(relocalizer.map(), query, learnt);
  const Recognition b = locate_by_bearings(relocalizer.map(), query, told);
  RecognitionOptions silent;
  silent.decision.min_score = 3.0;
  const Recognition c = locate_by_bearings(relocalizer.map(), query, silent);
  REQUIRE(a.candidates.front().pose);
  REQUIRE(c.candidates.front().pose);
  CHECK(a.candidates.front().score() == b.candidates.front().score());
  CHECK(a.candidates.front().score() > c.candidates.front().score());
  CHECK(error_text([&] {
          locate_by_bearings(relocalizer.map(), query,
                             with_learnt_looks(AppearanceKind("other", 8)));
        }) == refused_looks);
}

TEST_CASE("a calibration that learnt other looks than the map's is refused",
          "[recognition][appearance]") {
  RoomsWithLooks rooms(3);
  const auto query = rooms.seen(1, random_camera(rooms.random));
  const auto relocalizer = rooms.relocalizer();
  RecognitionOptions other = with_learnt_looks(AppearanceKind("other", 8));
  CHECK(error_text([&] { relocalizer.localize(query, other); }) == refused_looks);
  CHECK_NOTHROW(relocalizer.localize(query, with_learnt_looks(rooms.kind)));
  CHECK_THROWS_AS(relocalizer.localize(query, with_learnt_looks(AppearanceKind("twin", 16))),
                  InvalidValue);
  CHECK(error_text([&] { calibrate(rooms.relocalizer(other), rooms.ids); }) == refused_looks);
  CalibrateOptions options;
  options.appearance = made_up_looks(AppearanceKind("other", 8));
  CHECK(error_text([&] { calibrate(relocalizer, rooms.ids, {}, options); }) == refused_looks);

  LoopDetector<IndexedBag> loops({20.0, other});
  loops.bag().add(rooms.ids[0], rooms.graphs[0], rooms.infos[0]);
  CHECK(error_text([&] { loops.detect(1000.0, query); }) == refused_looks);
}

TEST_CASE("a map without looks takes any calibration", "[recognition][appearance]") {
  const RoomsWithLooks rooms(2);
  Relocalizer<> relocalizer(with_learnt_looks(AppearanceKind("other", 8)));
  std::mt19937 random(3);
  const auto seen = [&] { return SyntheticRoom(1, 8, 4).seen_from(random_camera(random)); };
  relocalizer.map().add(KeyframeId{1}, seen());
  CHECK(bool(relocalizer.localize(seen())));
}
