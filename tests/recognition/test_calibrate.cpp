// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <topobag/recognition/calibrate.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

namespace {

std::vector<KeyframeId> fill(Relocalizer<>& relocalizer, unsigned rooms) {
  std::mt19937 random(1);
  std::vector<KeyframeId> ids;
  for (unsigned i = 0; i < rooms; ++i) {
    ids.push_back(KeyframeId{i});
    relocalizer.map().add(ids.back(), SyntheticRoom(i, 8, 4).seen_from(random_camera(random)));
  }
  return ids;
}

bool differ(KeyframeId a, KeyframeId b) { return a != b; }

}  // namespace

TEST_CASE("a map is calibrated by its own permuted layouts", "[recognition]") {
  Relocalizer<> relocalizer;
  const auto ids = fill(relocalizer, 6);
  CalibrateOptions options;
  options.null_queries = 150;
  const Calibration calibration = calibrate(relocalizer, ids, {}, options);
  CHECK(calibration.source() == CalibrationSource::null_model);
  CHECK(calibration.negatives() == 0);
  CHECK(calibration.queries() == 150);
  const Calibration again = calibrate(relocalizer, ids, {}, options);
  for (const double rate : {0.1, 0.02, 1e-4}) {
    CHECK(again.threshold(rate).score == calibration.threshold(rate).score);
  }
}

TEST_CASE("certain negatives take the null model's place once there are enough", "[recognition]") {
  Relocalizer<> relocalizer;
  const auto ids = fill(relocalizer, 12);
  CalibrateOptions options;
  options.null_queries = 20;
  options.calibration.min_negatives = 13;
  const Calibration few = calibrate(relocalizer, ids, differ, options);
  CHECK(few.negatives() == 12);
  CHECK(few.source() == CalibrationSource::null_model);
  CHECK(few.queries() == 20);
  options.calibration.min_negatives = 12;
  const Calibration enough = calibrate(relocalizer, ids, differ, options);
  CHECK(enough.source() == CalibrationSource::certain_negatives);
  CHECK(enough.queries() == 12);
  // Without an other place there is nothing to look among.
  CHECK(calibrate(
            relocalizer, ids, [](KeyframeId, KeyframeId) { return false; }, options)
            .negatives() == 0);
}

TEST_CASE("negatives are looked up through the retrieval's own filter", "[recognition]") {
  RecognitionOptions options;
  options.retrieval.filter = [](KeyframeId id, const EntryInfo&) { return id == KeyframeId{0}; };
  Relocalizer<> relocalizer(options);
  const auto ids = fill(relocalizer, 6);
  CalibrateOptions calibrating;
  calibrating.null_queries = 0;
  // Key frame 0 has no other place that passes.
  CHECK(calibrate(relocalizer, ids, differ, calibrating).negatives() == 5);
}

TEST_CASE("enough certain negatives are all that is learnt from", "[recognition]") {
  Relocalizer<> relocalizer;
  const auto ids = fill(relocalizer, 6);
  CalibrateOptions with_null, without;
  with_null.calibration.min_negatives = without.calibration.min_negatives = 6;
  without.null_queries = 0;
  const Calibration a = calibrate(relocalizer, ids, differ, with_null);
  const Calibration b = calibrate(relocalizer, ids, differ, without);
  CHECK(a.queries() == 6);
  for (const double rate : {0.5, 0.1, 0.01})
    CHECK(a.threshold(rate).score == b.threshold(rate).score);
  std::size_t asked = 0;  // how often the map is, through its filter
  RecognitionOptions counting;
  counting.retrieval.filter = [&](KeyframeId, const EntryInfo&) { return ++asked > 0; };
  Relocalizer<> counted(counting);
  fill(counted, 6);
  calibrate(counted, ids, differ, without);
  const std::size_t by_negatives = asked;
  CHECK(by_negatives >= 30);
  asked = 0;
  calibrate(counted, ids, differ, with_null);
  CHECK(asked == by_negatives);
}

TEST_CASE("a calibrated decision asks for the score of its rate", "[recognition]") {
  Relocalizer<> relocalizer;
  const auto ids = fill(relocalizer, 6);
  CalibrateOptions calibrating;
  calibrating.null_queries = 150;
  RecognitionOptions options;
  options.decision.calibration = calibrate(relocalizer, ids, {}, calibrating);
  options.decision.false_accept_rate = 0.02;
  const double threshold = options.decision.calibration->threshold(0.02).score;
  CHECK(options.decision.threshold(7) == threshold);

  std::mt19937 random(7);
  const auto query = SyntheticRoom(3, 8, 4).seen_from(random_camera(random));
  const Recognition found = relocalizer.localize(query, options);
  REQUIRE(found);
  CHECK(found.accepted->id == KeyframeId{3});
  for (const CandidateReport& report : found.candidates) {
    CHECK(report.threshold == threshold);
    const bool one_pose = report.place_support && report.verdict != Verdict::degenerate &&
                          report.verdict != Verdict::ambiguous &&
                          report.verdict != Verdict::rivalled;
    CHECK(report.confidence.has_value() == one_pose);
  }
  CHECK(*found.accepted->confidence > 0.97);
  CHECK_FALSE(relocalizer.localize(query).accepted->confidence);

  options.decision.false_accept_rate = 0.0;
  CHECK_THROWS_AS(relocalizer.localize(query, options), InvalidValue);
}

TEST_CASE("the rate holds on layouts that were not learnt from", "[recognition]") {
  Relocalizer<> relocalizer;
  const auto ids = fill(relocalizer, 8);
  RecognitionOptions options;
  options.decision.calibration = calibrate(relocalizer, ids);
  options.decision.false_accept_rate = 0.05;
  std::size_t accepted = 0;
  for (std::uint32_t seed = 100000; seed < 100400; ++seed) {
    const auto layout = permuted_layout(*relocalizer.map().find(ids[seed % ids.size()]), seed);
    if (relocalizer.localize(layout, options)) ++accepted;
  }
  CHECK(accepted <= 32);  // 20 expected; three standard deviations
}

TEST_CASE("a query that compared nothing teaches nothing", "[recognition][regression]") {
  RecognitionOptions options;
  options.retrieval.min_similarity = 2.0;  // nothing resembles so much
  Relocalizer<> relocalizer(options);
  const Calibration calibration = calibrate(relocalizer, fill(relocalizer, 6));
  CHECK(calibration.queries() == 0);
  CHECK(calibration.threshold(0.01).extrapolated);
}

TEST_CASE("no confidence is given where several poses fit alike", "[recognition][regression]") {
  std::vector<SemanticNode<>> chairs;
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) chairs.push_back(object_at(56, {x, 0.0, 4.0 + z}));
  }
  const TopologyGraph<> square(std::move(chairs));
  RecognitionOptions options;
  options.decision.calibration.emplace();
  options.decision.false_accept_rate = 1.0;
  Relocalizer<> relocalizer(options);
  relocalizer.map().add(KeyframeId{1}, square);
  const Recognition found = relocalizer.localize(square);
  REQUIRE(found.candidates.size() == 1);
  CHECK(found.candidates[0].verdict == Verdict::ambiguous);
  CHECK_FALSE(found.candidates[0].confidence);
}

namespace {

/// Rooms 20 m apart along a corridor, three key frames in each, 30 s between rooms.
/// @param layouts  different rooms; with fewer than `rooms` they repeat
std::vector<KeyframeId> fill_with_poses(Relocalizer<>& relocalizer, unsigned rooms,
                                        unsigned layouts) {
  std::mt19937 random(1);
  std::vector<KeyframeId> ids;
  for (unsigned i = 0; i < 3 * rooms; ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    EntryInfo info;
    info.stamp = 30.0 * (i / 3) + i % 3;
    info.T_world_camera = Eigen::Translation3d(20.0 * (i / 3), 0.0, 0.0) * T_room_camera;
    ids.push_back(KeyframeId{i});
    relocalizer.map().add(ids.back(), SyntheticRoom(i / 3 % layouts, 8, 4).seen_from(T_room_camera),
                          info);
  }
  return ids;
}

CalibrateOptions by_pose_alone(std::size_t keyframes) {
  CalibrateOptions options;
  options.null_queries = 0;
  options.calibration.min_negatives = keyframes;
  return options;
}

}  // namespace

TEST_CASE("key frames with poses are negatives of all other poses", "[recognition]") {
  Relocalizer<> relocalizer;
  const auto ids = fill_with_poses(relocalizer, 8, 8);
  const auto never_asked = [](KeyframeId, KeyframeId) -> bool {
    throw InvalidValue("poses say what is elsewhere");
  };
  const Calibration calibration =
      calibrate(relocalizer, ids, never_asked, by_pose_alone(ids.size()));
  CHECK(calibration.negatives() == 24);
  CHECK(calibration.source() == CalibrationSource::certain_negatives);
  CHECK(calibration.carries_over());
  // The map is searched for chance alone: true matches score far above what was learnt.
  RecognitionOptions options = relocalizer.options();
  options.decision.calibration = calibration;
  options.decision.false_accept_rate = 0.05;
  std::mt19937 random(5);
  for (unsigned room = 0; room < 8; ++room) {
    const auto query = SyntheticRoom(room, 8, 4).seen_from(random_camera(random));
    const Recognition found = relocalizer.localize(query, options);
    CAPTURE(room);
    REQUIRE(found);
    CHECK(value(found.accepted->id) / 3 == room);
  }
}

TEST_CASE("a map whose layouts repeat says that its calibration will not carry over",
          "[recognition]") {
  Relocalizer<> different, alike;
  const auto ids = fill_with_poses(different, 8, 8);
  fill_with_poses(alike, 8, 2);
  const CalibrateOptions options = by_pose_alone(ids.size());
  const Calibration of_different = calibrate(different, ids, {}, options);
  const Calibration of_alike = calibrate(alike, ids, {}, options);
  CHECK(of_different.carries_over());
  CHECK_FALSE(of_alike.carries_over());
  CHECK(of_alike.carries_over().repeats > 0.9);
  CHECK(of_alike.threshold(0.1).score > of_different.threshold(0.1).score);
}

TEST_CASE("a key frame is not looked up among its neighbours in time", "[recognition]") {
  RecognitionOptions counting;
  std::size_t asked = 0;
  counting.retrieval.filter = [&](KeyframeId, const EntryInfo&) { return ++asked > 0; };
  Relocalizer<> relocalizer(counting);
  const auto ids = fill_with_poses(relocalizer, 4, 4);
  CalibrateOptions options = by_pose_alone(ids.size());
  options.by_pose.min_time_gap = 1e9;
  CHECK(calibrate(relocalizer, ids, {}, options).negatives() == 0);
  CHECK(asked == 0);
  options.by_pose.min_time_gap = 10.0;
  CHECK(calibrate(relocalizer, ids, {}, options).negatives() == 12);
  CHECK(asked >= 12 * 9);
}

TEST_CASE("draws are spread evenly over the whole map", "[recognition]") {
  for (std::size_t size = 1; size < 50; ++size) {
    for (std::size_t draws = 1; draws < 120; draws += 7) {
      std::vector<std::size_t> times(size);
      for (std::size_t i = 0; i < draws; ++i) ++times.at(detail::even_draw(i, draws, size));
      const auto [least, most] = std::minmax_element(times.begin(), times.end());
      CHECK(*most - *least <= 1);
      if (draws >= size) continue;
      std::size_t last = 0;  // no gap is longer than it must be
      for (std::size_t i = 0; i < draws; ++i) {
        const std::size_t drawn = detail::even_draw(i, draws, size);
        CHECK(drawn - last <= size / draws + 1);
        last = drawn;
      }
      CHECK(size - last <= size / draws + 1);
    }
  }
}

TEST_CASE("the null model draws from the end of a long map too", "[recognition][regression]") {
  RecognitionOptions options;
  options.retrieval.max_results = 8;
  Relocalizer<> relocalizer(options);
  const auto ids = fill(relocalizer, 30);
  std::vector<KeyframeId> every_fifth;
  for (std::size_t i = 0; i < ids.size(); i += 5) every_fifth.push_back(ids[i]);
  const std::vector<KeyframeId> first(ids.begin(), ids.begin() + 6);
  CalibrateOptions few;
  few.null_queries = 6;
  const auto scores = [&](const std::vector<KeyframeId>& from) {
    return calibrate(relocalizer, from, {}, few).null_scores().scores();
  };
  CHECK(scores(ids) == scores(every_fifth));
  CHECK(scores(ids) != scores(first));
}

TEST_CASE("a map of one place is calibrated by the null model, poses or not", "[recognition]") {
  Relocalizer<> relocalizer;
  const auto ids = fill_with_poses(relocalizer, 1, 1);
  CalibrateOptions options;
  options.null_queries = 30;
  options.calibration.min_negatives = 1;
  options.by_pose.min_time_gap = 0.5;
  const Calibration calibration = calibrate(relocalizer, ids, {}, options);
  CHECK(calibration.negatives() == 0);
  CHECK(calibration.source() == CalibrationSource::null_model);
  CHECK(calibration.queries() == 30);
}
