// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>

#include <Eigen/Geometry>

#include <topobag/recognition/place_graph.hpp>
#include <topobag/recognition/place_options.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

/// Rooms alike, 50 m apart, so that a query fits in every one.
void fill_with_like_rooms(Relocalizer<>& relocalizer, std::size_t rooms) {
  const SyntheticRoom room(31, 8, 8);
  for (std::size_t i = 0; i < rooms; ++i) {
    const Eigen::Isometry3d there(Eigen::Translation3d(50.0 * static_cast<double>(i), 0.0, 0.0));
    relocalizer.map().add(KeyframeId{i}, room.seen_from(Eigen::Isometry3d::Identity()),
                          standing_at(there));
  }
}

std::size_t judged_by_place(const Recognition& recognition) {
  return static_cast<std::size_t>(
      std::count_if(recognition.candidates.begin(), recognition.candidates.end(),
                    [](const CandidateReport& report) { return report.place_support; }));
}

}  // namespace

TEST_CASE("no more poses are judged by their place than the option says", "[recognition]") {
  const TopologyGraph<> query = SyntheticRoom(31, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  for (const std::size_t most : {1U, 2U, 5U}) {
    RecognitionOptions options;
    options.place.max_hypotheses = most;
    Relocalizer<> relocalizer(options);
    fill_with_like_rooms(relocalizer, 4);
    CHECK(judged_by_place(relocalizer.localize(query)) == std::min<std::size_t>(most, 4));
  }
  RecognitionOptions options;
  options.place.min_score = 1e6;
  Relocalizer<> relocalizer(options);
  fill_with_like_rooms(relocalizer, 4);
  CHECK(judged_by_place(relocalizer.localize(query)) == 0);
}

TEST_CASE("a rival counts though its place was not asked, unless no rivals are looked for",
          "[recognition]") {
  const TopologyGraph<> query = SyntheticRoom(31, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  for (const std::size_t rivals : {1U, 2U}) {
    RecognitionOptions options;
    options.place.max_hypotheses = 1;
    options.place.max_rivals = rivals;
    Relocalizer<> relocalizer(options);
    fill_with_like_rooms(relocalizer, 2);
    const Recognition found = relocalizer.localize(query);
    CHECK(found.candidates.front().verdict ==
          (rivals == 1 ? Verdict::accepted : Verdict::rivalled));
  }
}

TEST_CASE("poses are of one place as far as the options say", "[recognition]") {
  const SyntheticRoom room(31, 8, 8);
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  const TopologyGraph<> graph = room.seen_from(here);
  // The same objects twice, 0.8 m apart in the world: a loose map of one place, or two.
  for (const double apart : {0.5, 1.0}) {
    RecognitionOptions options;
    options.place.distinct_translation = apart;
    Relocalizer<> relocalizer(options);
    relocalizer.map().add(KeyframeId{0}, graph, standing_at(here));
    relocalizer.map().add(KeyframeId{1}, graph,
                          standing_at(Eigen::Isometry3d(Eigen::Translation3d(0.8, 0.0, 0.0))));
    CHECK(static_cast<bool>(relocalizer.localize(graph)) == (apart > 0.8));
  }
}

TEST_CASE("a place is put together of the key frames that the options admit", "[recognition]") {
  std::mt19937 random(32);
  const SyntheticRoom room(33, 9, 9);
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  const TopologyGraph<> candidate = SyntheticRoom(33, 4, 9).seen_from(here);  // the first four
  const TopologyGraph<> query = room.seen_from(here);
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{0}, candidate, standing_at(here));
  const Eigen::Isometry3d aside(Eigen::Translation3d(0.4, 0.0, 0.0));
  bag.add(KeyframeId{1}, room.seen_from(aside), standing_at(aside));
  const auto objects = [&](const PlaceOptions& options) {
    return place_graph(bag, KeyframeId{0}, candidate, query, here, {}, {}, options).size();
  };
  CHECK(objects({}) == 9);
  PlaceOptions near, few, short_sighted;
  near.radius = 0.3;
  CHECK(objects(near) == 4);
  few.max_keyframes = 0;
  CHECK(objects(few) == 4);
  short_sighted.margin = -1.0;  // the query has no view: what is not near its objects is left out
  CHECK(objects(short_sighted) == 0);
}

TEST_CASE("a place speaks against its key frame by no more than the option says", "[recognition]") {
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  const TopologyGraph<> graph = SyntheticRoom(7, 6, 2).seen_from(here);
  for (const double most : {0.1, 0.5}) {
    RecognitionOptions options;
    options.place.max_contradiction = most;
    Relocalizer<> relocalizer(options);
    relocalizer.map().add(KeyframeId{0}, graph, standing_at(here));
    // Clutter of the same classes, seen by others from the same spot.
    for (unsigned other = 1; other < 4; ++other) {
      relocalizer.map().add(KeyframeId{other}, SyntheticRoom(20 + other, 30, 2).seen_from(here),
                            standing_at(here, other));
    }
    const Recognition found = relocalizer.localize(graph);
    REQUIRE_FALSE(found.candidates.empty());
    const CandidateReport& best = found.candidates.front();
    REQUIRE(best.id == KeyframeId{0});
    CHECK(*best.place_support == Approx(best.pose->support() - most));
  }
}

TEST_CASE("one place is within both of its bounds, on either side", "[recognition]") {
  PlaceOptions options;
  options.distinct_translation = 0.8;
  options.distinct_rotation = 0.4;
  const auto is_one = [&](double metres, double radians) {
    const Eigen::Isometry3d T_a_b = Eigen::Translation3d(0.0, metres, 0.0) *
                                    Eigen::AngleAxisd(radians, Eigen::Vector3d::UnitX());
    CHECK(options.is_one_place(T_a_b) == options.is_one_place(T_a_b.inverse()));
    return options.is_one_place(T_a_b);
  };
  CHECK(is_one(0.0, 0.0));
  CHECK(is_one(0.79, -0.39));
  CHECK_FALSE(is_one(0.81, 0.0));
  CHECK_FALSE(is_one(0.0, 0.41));
  CHECK_FALSE(is_one(-0.81, 0.41));
}
