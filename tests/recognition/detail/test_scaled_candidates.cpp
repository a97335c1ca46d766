// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <topobag/bag/indexed_bag.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/graph/scaled_graph.hpp>
#include <topobag/recognition/changes.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/recognition/why.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

RecognitionOptions recognition_of_unknown_scale() {
  RecognitionOptions options;
  options.matching.scale = ScaleRange{};
  return options;
}

double drawn_scale(std::mt19937& random) {
  std::uniform_real_distribution<double> log_scale(std::log(0.4), std::log(2.5));
  return std::exp(log_scale(random));
}

}  // namespace

TEST_CASE("a camera without scale is found in the room it is in, at its pose", "[recognition]") {
  std::mt19937 random(2215);
  Relocalizer<> relocalizer(recognition_of_unknown_scale());
  std::vector<SyntheticRoom> rooms;
  std::vector<Eigen::Isometry3d> cameras;
  for (unsigned i = 0; i < 12; ++i) {
    rooms.emplace_back(i, 10, 6);
    // Two key frames a room, so that its place is asked as well.
    for (unsigned k = 0; k < 2; ++k) {
      cameras.push_back(random_camera(random));
      EntryInfo info = standing_at(cameras.back());
      info.T_world_camera->translation().x() += 100.0 * i;
      relocalizer.map().add(KeyframeId{2 * i + k}, rooms[i].seen_from(cameras.back()), info);
    }
  }
  std::size_t by_place = 0;
  for (unsigned i = 0; i < 12; ++i) {
    const Eigen::Isometry3d T_room_query = random_camera(random);
    const double scale = drawn_scale(random);
    const TopologyGraph<> query = scaled(rooms[i].seen_from(T_room_query), 1.0 / scale);
    const Recognition found = relocalizer.localize(query);
    CAPTURE(i, scale, why(found));
    REQUIRE(found);
    const std::uint64_t id = value(found.accepted->id);
    CHECK(id / 2 == i);
    const RelativePose& pose = *found.accepted->pose;
    CHECK(std::abs(pose.scale - scale) < 3.0 * pose.scale_deviation);
    const PoseError error =
        pose_error(cameras[id].inverse() * T_room_query, pose.T_candidate_query);
    CHECK(error.translation_m < 0.02);
    CHECK(error.rotation_deg < 0.5);
    CHECK(found.accepted->place_support);
    if (!found.accepted->place_pose) continue;
    // All that is said of the scale is that of the pose over the place.
    ++by_place;
    CHECK(pose.scale == found.accepted->place_scale);
    CHECK(pose.scale_covariance == found.accepted->place_scale_covariance);
    CHECK(pose.scale_covariance != found.candidates.front().pose->scale_covariance);
  }
  CHECK(by_place > 0);
}

TEST_CASE("a camera without scale in a room that is not in the map is not found", "[recognition]") {
  std::mt19937 random(2216);
  Relocalizer<> relocalizer(recognition_of_unknown_scale());
  for (unsigned i = 0; i < 12; ++i) {
    relocalizer.map().add(KeyframeId{i}, SyntheticRoom(i, 8, 6).seen_from(random_camera(random)));
  }
  for (unsigned i = 0; i < 24; ++i) {
    const double scale = drawn_scale(random);
    const Recognition found = relocalizer.localize(
        scaled(SyntheticRoom(1000 + i, 8, 6).seen_from(random_camera(random)), scale));
    CAPTURE(i);
    CHECK_FALSE(found);
    CHECK(found.usable);
  }
}

TEST_CASE("of an unknown scale, the candidates are the best of any scale", "[recognition]") {
  std::mt19937 random(2217);
  BagOfTopologyGraphs<> bag;
  IndexedBag indexed;
  for (unsigned i = 0; i < 40; ++i) {
    const TopologyGraph<> graph = SyntheticRoom(i, 10, 4).seen_from(random_camera(random));
    bag.add(KeyframeId{i}, graph);
    indexed.add(KeyframeId{i}, graph);
  }
  RecognitionOptions options = recognition_of_unknown_scale();
  options.retrieval.max_results = 5;
  std::size_t first = 0, unscaled_first = 0;
  for (unsigned i = 0; i < 40; ++i) {
    const double scale = drawn_scale(random);
    const TopologyGraph<> query =
        scaled(SyntheticRoom(i, 10, 4).seen_from(random_camera(random)), 1.0 / scale);
    const auto candidates = detail::candidates_of(bag, query, options);
    CHECK(candidates.size() == 5);
    CHECK(std::is_sorted(candidates.begin(), candidates.end()));
    for (const Candidate& candidate : candidates) {
      CHECK(candidate.similarity > 0.0);
    }
    first += candidates.front().id == KeyframeId{i} ? 1U : 0U;
    unscaled_first += bag.query(query, options.retrieval).front().id == KeyframeId{i} ? 1U : 0U;
    CHECK(detail::candidates_of(indexed, query, options).size() == 5);
  }
  CHECK(first >= 36);
  CHECK(unscaled_first < first);
  options.matching.scale.reset();
  const TopologyGraph<> query = SyntheticRoom(3, 10, 4).seen_from(random_camera(random));
  CHECK(detail::candidates_of(bag, query, options) == bag.query(query, options.retrieval));
}

TEST_CASE("what was found up to scale is told with its scale", "[recognition]") {
  std::mt19937 random(2218);
  const RecognitionOptions options = recognition_of_unknown_scale();
  Relocalizer<> relocalizer(options);
  const SyntheticRoom room(5, 10, 6);
  relocalizer.map().add(KeyframeId{7}, room.seen_from(random_camera(random)));
  const TopologyGraph<> query = scaled(room.seen_from(random_camera(random)), 1.0 / 0.71);
  const Recognition found = relocalizer.localize(query);
  REQUIRE(found);
  CHECK_THAT(why(found), Catch::Contains("up to scale: 1 unit of the query is 0.71 ± 0.0"));
  const Explanation explanation =
      explain(found, relocalizer.map(), query, ClassCatalog::coco80(), options);
  REQUIRE(explanation.candidates.at(0).scale);
  CHECK(explanation.candidates[0].scale->value ==
        Approx(found.accepted->pose->scale).epsilon(1e-3));
  CHECK_THAT(to_string(explanation), Catch::Contains("up to scale: 1 unit of the query is 0.71"));
  CHECK(explanation.candidates[0].matched.size() >= 9);
  for (const ExplainedMatch& match : explanation.candidates[0].matched) {
    CHECK(match.distance < 0.02);
  }
  const auto candidate = relocalizer.map().find(KeyframeId{7});
  CHECK(coincident_objects(*candidate, query, *found.accepted->pose).size() == 10);
  const Recognition known = Relocalizer<>(RecognitionOptions{}, relocalizer.map())
                                .localize(room.seen_from(random_camera(random)));
  REQUIRE(known);
  CHECK_THAT(why(known), !Catch::Contains("scale"));
}
