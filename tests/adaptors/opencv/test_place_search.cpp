// SPDX-License-Identifier: MIT
// Places are tested by a host's matcher and optimiser: on a small host whose camera moves along a
// line, so that a pose is how many px off its map points are projected.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <set>
#include <vector>

#include "../../../examples/orb_slam/hooks/PlaceSearch.h"
#include "catch.hpp"

namespace line_host {

struct MapPoint {
  std::size_t feature;  ///< of the frame, that resembles it
  int distance;         ///< of the two descriptors, bits
  bool wrong;           ///< they show different things
};

struct KeyFrame {
  std::vector<MapPoint*> points;
  std::vector<KeyFrame*> neighbors;
  bool bad = false;

  bool isBad() const { return bad; }
  std::vector<KeyFrame*> GetBestCovisibilityKeyFrames(int most) const {
    const auto count = std::min(neighbors.size(), static_cast<std::size_t>(most));
    return {neighbors.begin(), neighbors.begin() + static_cast<std::ptrdiff_t>(count)};
  }
};

struct Frame {
  explicit Frame(int features)
      : N(features),
        mvpMapPoints(static_cast<std::size_t>(features)),
        mvbOutlier(static_cast<std::size_t>(features)) {}

  int N;
  std::vector<MapPoint*> mvpMapPoints;
  std::vector<bool> mvbOutlier;
  float off = 1e6F;  ///< px; 0 is the true pose
  int ransacs = 0;
};

struct Matcher {
  Matcher(float, bool) {}

  void SearchByProjection(Frame& frame, KeyFrame* key_frame, const std::set<MapPoint*>& found,
                          float window, int distance) {
    if (std::abs(frame.off) > window) return;
    for (MapPoint* point : key_frame->points) {
      MapPoint*& match = frame.mvpMapPoints[point->feature];
      if (match || found.count(point) != 0 || point->distance > distance) continue;
      match = point;
    }
  }
};

struct PoseOptimizer {
  static int PoseOptimization(Frame* frame) {
    int good = 0;
    for (std::size_t i = 0; i < frame->mvpMapPoints.size(); ++i) {
      const MapPoint* const point = frame->mvpMapPoints[i];
      frame->mvbOutlier[i] = point && point->wrong;
      good += point && !point->wrong ? 1 : 0;
    }
    if (good >= 3) frame->off = 0.0F;
    return good;
  }
};

struct Host {
  using KeyFrame = line_host::KeyFrame;
  using Frame = line_host::Frame;
  using MapPoint = line_host::MapPoint;
  using ORBmatcher = Matcher;
  using Optimizer = PoseOptimizer;

  static void SetPose(Frame& frame, const topobag_hooks::Place<KeyFrame>& place) {
    frame.off = place.Tcw[3];
  }
  static void ApplyRansac(Frame& frame) { ++frame.ransacs; }
};

using Search = topobag_hooks::PlaceSearch<Host>;

struct Hooks {
  std::vector<topobag_hooks::Place<KeyFrame>> places;
  std::vector<int> tried;

  std::vector<topobag_hooks::Place<KeyFrame>> RelocalizationPlaces() const { return places; }
  void PlacesTried(int accepted) { tried.push_back(accepted); }
};

/// A key frame whose map points resemble the features of a frame, each another one.
struct Scene {
  KeyFrame* key_frame(const std::vector<MapPoint>& seen) {
    key_frames.push_back(std::make_unique<KeyFrame>());
    for (const MapPoint& point : seen) {
      points.push_back(std::make_unique<MapPoint>(point));
      key_frames.back()->points.push_back(points.back().get());
    }
    return key_frames.back().get();
  }
  /// So many right points that are this much alike, from that feature on.
  KeyFrame* alike(std::size_t count, int distance, std::size_t first = 0) {
    std::vector<MapPoint> seen;
    for (std::size_t i = 0; i < count; ++i) seen.push_back({first + i, distance, false});
    return key_frame(seen);
  }

  std::vector<std::unique_ptr<MapPoint>> points;
  std::vector<std::unique_ptr<KeyFrame>> key_frames;
};

topobag_hooks::Place<KeyFrame> place(KeyFrame* key_frame, float off) {
  topobag_hooks::Place<KeyFrame> made{key_frame, {}, 1.0F};
  made.Tcw[3] = off;
  return made;
}

std::size_t matched(const Frame& frame) {
  return frame.mvpMapPoints.size() -
         static_cast<std::size_t>(
             std::count(frame.mvpMapPoints.begin(), frame.mvpMapPoints.end(), nullptr));
}

}  // namespace line_host

TEST_CASE("the first place that stands the host's test gives the frame its pose", "[hooks]") {
  line_host::Scene scene;
  line_host::KeyFrame* const few = scene.alike(49, 30);
  line_host::KeyFrame* const culled = scene.alike(60, 30);
  culled->bad = true;
  line_host::KeyFrame* const right = scene.alike(50, 30);
  right->points.push_back(scene.key_frame({{70, 20, true}})->points.front());
  line_host::Hooks hooks;
  hooks.places = {place(few, 10.0F), place(culled, 0.0F), place(right, 10.0F), place(right, 0.0F)};
  line_host::Frame frame(80);
  CHECK(line_host::Search::Relocalize(hooks, frame));
  CHECK(hooks.tried == std::vector<int>{2});
  CHECK(frame.off == 0.0F);
  CHECK(matched(frame) == 50);
  CHECK(frame.mvpMapPoints[70] == nullptr);  // an outlier
}

TEST_CASE("a frame that stands at no place is left without points", "[hooks]") {
  line_host::Scene scene;
  line_host::Hooks hooks;
  hooks.places = {place(scene.alike(49, 30), 0.0F), place(scene.alike(60, 30), 150.0F)};
  line_host::Frame frame(60);
  CHECK_FALSE(line_host::Search::Relocalize(hooks, frame));
  CHECK(hooks.tried == std::vector<int>{-1});
  CHECK(matched(frame) == 0);

  line_host::Hooks none;
  line_host::Frame as_it_was(60);
  as_it_was.mvpMapPoints[3] = scene.points.front().get();
  CHECK_FALSE(line_host::Search::Relocalize(none, as_it_was));
  CHECK(none.tried.empty());
  CHECK(matched(as_it_was) == 1);
}

TEST_CASE("the points of covisible key frames are asked too", "[hooks]") {
  line_host::Scene scene;
  line_host::KeyFrame* const key_frame = scene.alike(20, 30);
  for (std::size_t i = 0; i < 12; ++i) {
    key_frame->neighbors.push_back(scene.alike(3, 30, 20 + 3 * i));
  }
  const auto around = line_host::Search::Around(key_frame);
  REQUIRE(around.size() == 11);
  CHECK(around.front() == key_frame);
  CHECK(around.back() == key_frame->neighbors[9]);
  line_host::Hooks hooks;
  hooks.places = {place(key_frame, 10.0F)};
  line_host::Frame frame(60);
  CHECK(line_host::Search::Relocalize(hooks, frame));
  CHECK(matched(frame) == 50);
}

TEST_CASE("what lies further around counts where a place has thirty matches", "[hooks]") {
  struct Case {
    std::size_t at_place, further;
    bool stands;
  };
  for (const Case& given : {Case{50, 0, true},
                            {50, 8, true},
                            {30, 20, true},
                            {30, 19, false},
                            {29, 30, false},
                            {49, 0, false}}) {
    CAPTURE(given.at_place, given.further);
    line_host::Scene scene;
    line_host::KeyFrame* const key_frame = scene.alike(given.at_place - 1, 30);
    line_host::KeyFrame* const next = scene.alike(1, 30, given.at_place - 1);
    line_host::KeyFrame* const further = scene.alike(given.further, 30, given.at_place);
    key_frame->neighbors = {next};
    next->neighbors = {key_frame, further};
    further->neighbors = {next, scene.alike(3, 30, 60)};
    line_host::Hooks hooks;
    hooks.places = {place(key_frame, 10.0F)};
    line_host::Frame frame(70);
    CHECK(line_host::Search::Relocalize(hooks, frame) == given.stands);
    CHECK(matched(frame) == (given.stands ? given.at_place + given.further : 0));
  }
}

TEST_CASE("windows and distances of the searches, against the rule counted out", "[hooks]") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> bits(20, 110), off(0, 130), wrong(0, 9);
  std::uniform_int_distribution<std::size_t> count(5, 110);
  std::size_t stood = 0, by_wide_window = 0;
  for (int round = 0; round < 1000; ++round) {
    line_host::Scene scene;
    const int shift = off(random);
    const int least = bits(random);
    std::uniform_int_distribution<int> alike(std::min(least, 105), 110);
    std::vector<line_host::MapPoint> seen;
    const std::size_t points = count(random);
    for (std::size_t i = 0; i < points; ++i) {
      seen.push_back({i, round % 2 == 0 ? bits(random) : alike(random), wrong(random) == 0});
    }
    const auto right_within = [&](int distance) {
      return std::count_if(seen.begin(), seen.end(), [&](const line_host::MapPoint& point) {
        return !point.wrong && point.distance <= distance;
      });
    };
    const bool narrow = shift <= 40 && right_within(64) >= 10;
    const bool wide = shift <= 100 && right_within(50) >= 10;
    const bool expected = (narrow || wide) && right_within(80) >= 20 && right_within(100) >= 50;
    line_host::Hooks hooks;
    hooks.places = {place(scene.key_frame(seen), static_cast<float>(shift))};
    line_host::Frame frame(120);
    CAPTURE(round, shift, points);
    CHECK(line_host::Search::Relocalize(hooks, frame) == expected);
    if (!expected) continue;
    ++stood;
    by_wide_window += narrow ? 0U : 1U;
    CHECK(frame.ransacs == 1);
    CHECK(static_cast<std::ptrdiff_t>(matched(frame)) == right_within(100));
  }
  CHECK(stood > 100);
  CHECK(by_wide_window > 50);
}
