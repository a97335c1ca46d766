// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <random>
#include <type_traits>

#include <topobag/bag/indexed_bag.hpp>
#include <topobag/recognition/loop_detector.hpp>

#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

TEST_CASE("a loop is never younger than the least gap", "[recognition]") {
  std::mt19937 random(1);
  const SyntheticRoom room(1, 8, 8);  // the camera never leaves: only the gap keeps it from loops
  LoopOptions options;
  options.min_gap = 10.0;
  LoopDetector<> loops(options);
  for (unsigned i = 0; i < 30; ++i) {
    const Recognition loop =
        loops.detect_and_add(KeyframeId{i}, i, room.seen_from(random_camera(random)));
    CAPTURE(i);
    for (const CandidateReport& report : loop.candidates) CHECK(value(report.id) + 10 <= i);
    CHECK(loop.candidates.size() == (i < 10 ? 0u : i - 9u));
    CHECK(loop.accepted.has_value() == (i >= 10));
  }
  CHECK(loops.bag().size() == 30);
}

TEST_CASE("detect adds nothing, detect_and_add keeps stamp and info", "[recognition]") {
  const TopologyGraph<> graph = SyntheticRoom(1, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  LoopDetector<> loops;
  loops.detect(1.0, graph);
  CHECK(loops.bag().empty());
  EntryInfo info;
  info.session = 3;
  loops.detect_and_add(KeyframeId{5}, 2.0, graph, info);
  REQUIRE(loops.bag().info(KeyframeId{5}));
  CHECK(loops.bag().info(KeyframeId{5})->stamp == 2.0);
  CHECK(loops.bag().info(KeyframeId{5})->session == 3);
}

TEST_CASE("another session is an earlier visit, whatever its clock says", "[recognition]") {
  const std::uint32_t monday = 1, tuesday = 2;
  for (const double start : {1.4e9, 1.3e9, 0.0}) {  // of Tuesday's clock
    LoopDetector<> loops;
    const auto drive = [&](std::uint32_t session, double first_stamp, std::uint64_t first_id) {
      std::size_t found = 0;
      EntryInfo info;
      info.session = session;
      for (unsigned room = 0; room < 5; ++room) {
        const auto seen = SyntheticRoom(room, 10, 8).seen_from(Eigen::Isometry3d::Identity());
        const Recognition loop = loops.detect_and_add(KeyframeId{first_id + room},
                                                      first_stamp + 30.0 * room, seen, info);
        if (loop && loop.accepted->id == KeyframeId{room}) ++found;
      }
      return found;
    };
    CHECK(drive(monday, 1.3e9, 0) == 0);
    CHECK(drive(tuesday, start, 100) == 5);
  }
}

TEST_CASE("an entry without a stamp is no earlier visit", "[recognition]") {
  const TopologyGraph<> graph = SyntheticRoom(1, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  LoopDetector<> loops;
  loops.bag().add(KeyframeId{1}, graph);
  CHECK(loops.detect(1000.0, graph).candidates.empty());
  CHECK(loops.detect(1000.0, graph, 1).candidates.size() == 1);  // but of another session
}

TEST_CASE("an indexed bag finds the same loops as a plain one over the same graphs",
          "[recognition]") {
  std::mt19937 random(7);
  const SyntheticRoom rooms[] = {SyntheticRoom(1, 10, 8), SyntheticRoom(2, 10, 8)};
  const ClassPairDistanceHistogram similarity;
  using PlainBag = BagOfTopologyGraphs<TopologyGraph<>, ClassPairDistanceHistogram>;
  LoopOptions options;
  options.min_gap = 5.0;
  LoopDetector<IndexedBag> indexed(options);
  LoopDetector<PlainBag> plain(options, PlainBag(similarity));
  std::size_t accepted = 0;
  for (unsigned i = 0; i < 40; ++i) {
    const auto seen = rooms[i / 10 % 2].seen_from(random_camera(random));
    const TopologyGraph<> graph = decode(encode(seen));
    const Recognition a = indexed.detect_and_add(KeyframeId{i}, i, graph);
    const Recognition b = plain.detect_and_add(KeyframeId{i}, i, graph);
    CAPTURE(i);
    REQUIRE(a.candidates.size() == b.candidates.size());
    for (std::size_t k = 0; k < a.candidates.size(); ++k) {
      CHECK(a.candidates[k].id == b.candidates[k].id);
    }
    REQUIRE(a.accepted.has_value() == b.accepted.has_value());
    if (!a.accepted) continue;
    ++accepted;
    CHECK(a.accepted->id == b.accepted->id);
    CHECK(a.accepted->id < KeyframeId{i - 4});
  }
  CHECK(accepted > 20);
}

TEST_CASE("the user's filter holds beside the gap", "[recognition]") {
  const TopologyGraph<> graph = SyntheticRoom(1, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  LoopOptions options;
  options.recognition.retrieval.filter = [](KeyframeId id, const EntryInfo&) {
    return id != KeyframeId{1};
  };
  LoopDetector<> loops(options);
  loops.detect_and_add(KeyframeId{1}, 0.0, graph);
  CHECK(loops.detect(100.0, graph).candidates.empty());
  loops.detect_and_add(KeyframeId{2}, 0.0, graph);
  CHECK(loops.detect(100.0, graph).accepted->id == KeyframeId{2});
}

TEST_CASE("a key frame that is refused leaves the bag as it was", "[recognition]") {
  const TopologyGraph<> graph = SyntheticRoom(1, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  LoopDetector<> loops;
  loops.detect_and_add(KeyframeId{1}, 0.0, graph);
  CHECK_THROWS_AS(loops.detect_and_add(KeyframeId{1}, 50.0, graph), InvalidId);
  CHECK_THROWS_AS(loops.detect_and_add(KeyframeId{2}, std::nan(""), graph), InvalidValue);
  CHECK(loops.bag().size() == 1);
  CHECK(loops.bag().info(KeyframeId{1})->stamp == 0.0);
}

TEST_CASE("a stamp or a gap that is not finite is refused", "[recognition][regression]") {
  const TopologyGraph<> graph = SyntheticRoom(1, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  LoopOptions options;
  LoopDetector<> loops(options);
  loops.detect_and_add(KeyframeId{1}, 99.0, graph);
  CHECK_THROWS_AS(loops.detect(std::nan(""), graph), InvalidValue);
  options.min_gap = std::nan("");
  CHECK_THROWS_AS(LoopDetector<>(options).detect(1.0, graph), InvalidValue);
}

TEST_CASE("a running detector takes other options, and keeps its key frames", "[recognition]") {
  const TopologyGraph<> graph = SyntheticRoom(1, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  LoopDetector<> loops;
  loops.detect_and_add(KeyframeId{1}, 0.0, graph);
  CHECK(loops.detect(100.0, graph));
  RecognitionOptions strict = loops.options();
  strict.decision.min_score = 1e6;
  CHECK_FALSE(loops.detect(100.0, graph, 0, strict));  // for this key frame alone
  CHECK(loops.detect(100.0, graph));
  CHECK(loops.detect(5.0, graph, 0, strict).candidates.empty());  // the gap holds
  loops.set_options(strict);
  CHECK(loops.options().decision.min_score == 1e6);
  CHECK(loops.bag().size() == 1);
  CHECK_FALSE(loops.detect(100.0, graph));

  Calibration calibration;
  for (int i = 0; i < 250; ++i) calibration.add_negative(0.001 * i);
  RecognitionOptions calibrated;
  calibrated.decision.calibration = calibration;
  loops.set_options(calibrated);
  const Recognition loop = loops.detect(100.0, graph);
  REQUIRE(loop);
  CHECK(loop.accepted->threshold == calibration.threshold(1e-3).score);
  CHECK(*loop.accepted->confidence > 0.99);
  CHECK(*loop.accepted->confidence < 1.0);
}

TEST_CASE("a detector refers to a map that others use as well", "[recognition]") {
  std::mt19937 random(9);
  const SyntheticRoom room(1, 8, 8);
  IndexedBag map;
  LoopOptions options;
  options.min_gap = 5.0;
  LoopDetector loops(map, options);
  static_assert(std::is_same_v<decltype(loops), LoopDetector<IndexedBag&>>);
  const Relocalizer relocalizer(map);
  const Eigen::Isometry3d T_world_camera = random_camera(random);
  loops.detect_and_add(KeyframeId{1}, 0.0, room.seen_from(T_world_camera),
                       standing_at(T_world_camera));
  CHECK(map.size() == 1);
  const Eigen::Isometry3d T_world_query = random_camera(random);
  const Recognition loop = loops.detect(9.0, room.seen_from(T_world_query));
  REQUIRE(loop);
  CHECK(relocalizer.localize(room.seen_from(T_world_query)));
  REQUIRE(loops.T_world_query(loop));
  const Eigen::Isometry3d error = T_world_query.inverse() * loops.T_world_query(loop)->T;
  CHECK(error.translation().norm() < 0.05);
  const PoseWithCovariance<> entry{T_world_camera, Eigen::Matrix<double, 6, 6>::Identity()};
  CHECK(loops.T_world_query(loop, entry)->covariance.trace() > 6.0);
}
