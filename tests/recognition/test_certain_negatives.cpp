// SPDX-License-Identifier: MIT
#include <optional>
#include <random>

#include <topobag/recognition/certain_negatives.hpp>
#include <topobag/recognition/loop_detector.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

namespace {

Eigen::Isometry3d shifted_by(double x, double radians = 0.0) {
  return Eigen::Translation3d(x, 0.0, 0.0) *
         Eigen::Isometry3d(Eigen::AngleAxisd(radians, Eigen::Vector3d::UnitY()));
}

EntryInfo posed(const Eigen::Isometry3d& T_world_camera, std::optional<double> stamp = {}) {
  EntryInfo info;
  info.T_world_camera = T_world_camera;
  info.stamp = stamp;
  return info;
}

/// A map of one room, and of it again 20 m away where it `repeats`, five key frames each.
Relocalizer<> map_of_room(bool repeats, unsigned seed = 1) {
  Relocalizer<> relocalizer;
  std::mt19937 random(seed);
  const SyntheticRoom room(seed, 8, 4);
  for (unsigned i = 0; i < (repeats ? 10u : 5u); ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    relocalizer.map().add(KeyframeId{i}, room.seen_from(T_room_camera),
                          posed(shifted_by(i < 5 ? 0.0 : 20.0) * T_room_camera));
  }
  return relocalizer;
}

}  // namespace

TEST_CASE("a pose is elsewhere beyond a distance or a turn", "[recognition]") {
  const PoseNegativeOptions options;
  const Eigen::Isometry3d T_world_query = shifted_by(3.0, 0.4);
  const auto elsewhere = [&](const Eigen::Isometry3d& T_query_other) {
    CHECK(options.elsewhere(T_world_query, T_world_query * T_query_other) ==
          options.elsewhere(T_world_query * T_query_other, T_world_query));
    return options.elsewhere(T_world_query, T_world_query * T_query_other);
  };
  CHECK_FALSE(elsewhere(shifted_by(0.0)));
  CHECK_FALSE(elsewhere(shifted_by(0.99, 0.78)));
  CHECK(elsewhere(shifted_by(1.01)));
  CHECK(elsewhere(shifted_by(0.0, 0.79)));
  CHECK(elsewhere(shifted_by(0.0, -0.79)));
}

TEST_CASE("a neighbour is near in time, or in its id, within its session", "[recognition]") {
  const PoseNegativeOptions options;
  EntryInfo at_100, at_109, at_110, other_session, unstamped;
  at_100.stamp = 100.0;
  at_109.stamp = 109.0;
  at_110.stamp = 110.0;
  other_session.stamp = 100.0;
  other_session.session = 1;
  const KeyframeId id{50}, near{60}, far{80};
  CHECK(options.is_neighbor(id, at_100, far, at_109));
  CHECK(options.is_neighbor(far, at_109, id, at_100));
  CHECK_FALSE(options.is_neighbor(id, at_100, near, at_110));
  CHECK_FALSE(options.is_neighbor(id, at_100, near, other_session));
  CHECK(options.is_neighbor(id, at_100, near, unstamped));
  CHECK_FALSE(options.is_neighbor(id, unstamped, far, unstamped));
  CHECK_FALSE(options.is_neighbor(far, unstamped, id, unstamped));
  CHECK(options.is_neighbor(id, at_100, id, other_session));  // itself
}

TEST_CASE("the true place is no negative, its repetition is", "[recognition]") {
  std::mt19937 random(7);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Relocalizer<> once = map_of_room(false, seed), twice = map_of_room(true, seed);
    const SyntheticRoom room(seed, 8, 4);
    const Eigen::Isometry3d T_world_query = random_camera(random);
    const auto query = room.seen_from(T_world_query);
    const auto open = without_threshold(once.options());
    const Recognition in_once = once.localize(query, open), in_twice = twice.localize(query, open);
    CAPTURE(seed);
    REQUIRE(in_once);
    const auto chance = false_score_by_pose(in_once, once.map(), T_world_query);
    const auto repeated = false_score_by_pose(in_twice, twice.map(), T_world_query);
    REQUIRE(repeated);
    CHECK(*repeated > 0.5 * in_once.accepted->score());
    CHECK((!chance || *chance < *repeated));
    const auto repeats = [&](const Recognition& found, const Relocalizer<>& map) {
      Calibration calibration;
      add_negative_by_pose(calibration, found, map.map(), T_world_query);
      return calibration.repeats();
    };
    CHECK(repeats(in_twice, twice) == 1);
    CHECK(repeats(in_once, once) == 0);
    // Said to stand elsewhere, the query finds its own place wrongly.
    const auto displaced =
        false_score_by_pose(in_once, once.map(), shifted_by(5.0) * T_world_query);
    REQUIRE(displaced);
    CHECK(*displaced >= in_once.accepted->score());
  }
}

TEST_CASE("the limits of what is elsewhere are the user's", "[recognition]") {
  std::mt19937 random(8);
  const Relocalizer<> twice = map_of_room(true);
  const Eigen::Isometry3d T_world_query = random_camera(random);
  const Recognition found = twice.localize(SyntheticRoom(1, 8, 4).seen_from(T_world_query),
                                           without_threshold(twice.options()));
  PoseNegativeOptions blind;
  blind.max_translation = 100.0;
  blind.max_rotation = 4.0;
  CHECK(false_score_by_pose(found, twice.map(), T_world_query));
  CHECK_FALSE(false_score_by_pose(found, twice.map(), T_world_query, blind));
}

TEST_CASE("what compared nothing, or nothing with a pose, teaches nothing", "[recognition]") {
  Relocalizer<> relocalizer;
  const auto graph = SyntheticRoom(1, 8, 4).seen_from(Eigen::Isometry3d::Identity());
  Calibration calibration;
  const auto learn = [&] {
    const Recognition found = relocalizer.localize(graph, without_threshold(relocalizer.options()));
    return add_negative_by_pose(calibration, found, relocalizer.map(), shifted_by(9.0));
  };
  CHECK_FALSE(learn());
  CHECK_FALSE(add_negative(calibration, Recognition{}));
  relocalizer.map().add(KeyframeId{1}, graph);
  CHECK_FALSE(learn());
  CHECK(calibration.negatives() == 0);
  relocalizer.map().add(KeyframeId{2}, graph, posed(Eigen::Isometry3d::Identity()));
  CHECK(learn());
  CHECK(calibration.negatives() == 1);
  CHECK(add_negative(calibration, relocalizer.localize(graph)));
  CHECK(calibration.negatives() == 2);
}

TEST_CASE("a map of the query's place alone teaches nothing of others",
          "[recognition][regression]") {
  std::mt19937 random(4);
  const Eigen::Isometry3d T_world_query = random_camera(random);
  const auto query = SyntheticRoom(1, 8, 4).seen_from(T_world_query);
  const auto learns = [&](const Relocalizer<>& map) {
    Calibration calibration;
    const Recognition found = map.localize(query, without_threshold(map.options()));
    return add_negative_by_pose(calibration, found, map.map(), T_world_query);
  };
  CHECK_FALSE(learns(map_of_room(false)));
  CHECK(learns(map_of_room(true)));  // half of it is elsewhere
  CHECK(learns(map_of_room(false, 2)));
}

TEST_CASE("a false score is that of the match a query would accept", "[recognition]") {
  const Relocalizer<> relocalizer = map_of_room(false);
  const auto graph = *relocalizer.map().find(KeyframeId{1});
  const Recognition found = relocalizer.localize(graph, without_threshold(relocalizer.options()));
  REQUIRE(false_score(found));
  CHECK(*false_score(found) == found.accepted->score());
  CHECK_FALSE(false_score(Recognition{}));
}

TEST_CASE("a loop detector learns while it maps, and decides by what it learnt", "[recognition]") {
  std::mt19937 random(3);
  const SyntheticRoom rooms[] = {SyntheticRoom(1, 8, 4), SyntheticRoom(2, 8, 4),
                                 SyntheticRoom(3, 8, 4)};
  LoopOptions options;
  options.min_gap = 5.0;
  LoopDetector<> loops(options);
  CalibrationOptions calibrating;
  calibrating.min_negatives = 20;
  Calibration calibration(calibrating);
  std::size_t accepted = 0;
  for (unsigned i = 0; i < 60; ++i) {
    const unsigned room = i / 10 % 3;
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    const Eigen::Isometry3d T_world_camera = shifted_by(20.0 * room) * T_room_camera;
    const auto graph = rooms[room].seen_from(T_room_camera);
    const Recognition all = loops.detect(i, graph, 0, without_threshold(loops.options()));
    // Nothing to compare with, then the first room alone, which leaves no room for a false match.
    CHECK(add_negative_by_pose(calibration, all, loops.bag(), T_world_camera) == (i >= 10));
    RecognitionOptions decided = loops.options();
    decided.decision.calibration = calibration;
    decided.decision.false_accept_rate = 0.05;
    loops.set_options(decided);
    const Recognition loop = loops.detect_and_add(KeyframeId{i}, i, graph, posed(T_world_camera));
    for (const CandidateReport& report : loop.candidates) {
      CHECK(report.threshold == calibration.threshold(0.05, loop.places).score);
    }
    if (!loop) continue;
    ++accepted;
    const auto info = loops.bag().info(loop.accepted->id);
    CHECK_FALSE(PoseNegativeOptions{}.elsewhere(
        T_world_camera, *info->T_world_camera * loop.accepted->pose->T_candidate_query));
  }
  CHECK(calibration.source() == CalibrationSource::certain_negatives);
  CHECK(calibration.negatives() == 50);
  CHECK(calibration.carries_over());
  CHECK(accepted > 20);
}

TEST_CASE("nothing is learnt by a pose that is none", "[recognition][regression]") {
  const Relocalizer<> relocalizer = map_of_room(false);
  Eigen::Isometry3d mirrored = Eigen::Isometry3d::Identity();
  mirrored.linear().diagonal().x() = -1.0;
  Calibration calibration;
  CHECK_THROWS_AS(false_score_by_pose(Recognition{}, relocalizer.map(), mirrored), InvalidValue);
  CHECK_THROWS_AS(add_negative_by_pose(calibration, Recognition{}, relocalizer.map(), mirrored),
                  InvalidValue);
}
