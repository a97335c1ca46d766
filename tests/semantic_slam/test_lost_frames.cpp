// SPDX-License-Identifier: MIT
// What the program beside an ORB-SLAM makes of lost frames, with depth and without.
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include <host.hpp>
#include <semantic_slam.hpp>

#include <topobag/error.hpp>

#include "catch.hpp"
#include "semantic_slam/seen_room.hpp"

TEST_CASE("a lost frame is looked up by its objects, or by their directions without depth",
          "[hooks]") {
  std::mt19937 random(6);
  SeenRoom seen;
  const cv::Mat image = cv::Mat::zeros(4, 4, CV_8U);
  semantic::Settings settings;
  settings.camera = seen.camera;
  semantic::SemanticSlam beside(
      settings, topobag::ClassCatalog::coco80(),
      [&seen](const semantic::Images& images) { return seen.detect(images.stamp); });
  host::Map map;
  std::vector<std::unique_ptr<host::KeyFrame>> key_frames;
  for (unsigned long id = 1; id <= 3; ++id) {
    const double stamp = static_cast<double>(id);
    seen.cameras[stamp] = random_camera(random);
    host::Frame frame(stamp);
    beside.FrameMade(frame, image, image);
    key_frames.push_back(std::make_unique<host::KeyFrame>(id, stamp, seen.cameras[stamp], map));
    beside.KeyFrameMade(key_frames.back().get());
    beside.Added(key_frames.back().get());
  }
  beside.wait_idle();
  REQUIRE(beside.size() == 3);
  const bool depths[] = {true, false, true};
  double stamp = 10.0;
  for (const bool with_depth : depths) {
    seen.knows_depth = with_depth;
    stamp += 5.0;
    seen.cameras[stamp] = random_camera(random);
    host::Frame frame(stamp);
    beside.FrameMade(frame, image, image);
    std::vector<host::KeyFrame*> candidates;
    beside.RelocalizationCandidates(&frame, candidates, nullptr);
    CAPTURE(with_depth);
    CHECK_FALSE(candidates.empty());
    CHECK_FALSE(beside.RelocalizationPlaces().empty());
    const semantic::OfferedPlaces offered = beside.offered_places().back();
    CHECK(offered.by_bearings != with_depth);
    CHECK(offered.verified > 0);
    REQUIRE(offered.T_world_camera);
    const Eigen::Isometry3d off = offered.T_world_camera->inverse() * seen.cameras[stamp];
    CHECK(off.translation().norm() < 0.1);
    CHECK(beside.times().count("tracking, lost: query by directions") == (stamp < 20.0 ? 0U : 1U));
  }
  CHECK(beside.failures().first == 0);
  beside.stop();
}

TEST_CASE("a key frame whose detector fails is lost with the reason, and nothing waits for it",
          "[hooks][regression]") {
  const cv::Mat image = cv::Mat::zeros(4, 4, CV_8U);
  semantic::Settings settings;
  settings.camera = {400.0, 400.0, 319.5, 239.5, 640, 480};
  semantic::SemanticSlam beside(
      settings, topobag::ClassCatalog::coco80(),
      [](const semantic::Images& images) -> std::vector<topobag::RangedDetection> {
        if (images.stamp > 1.5) throw topobag::Error("the network is of another size");
        return {};
      });
  host::Map map;
  std::vector<std::unique_ptr<host::KeyFrame>> key_frames;
  for (unsigned long id = 1; id <= 3; ++id) {
    const auto stamp = static_cast<double>(id);
    host::Frame frame(stamp);
    beside.FrameMade(frame, image, image);
    key_frames.push_back(
        std::make_unique<host::KeyFrame>(id, stamp, Eigen::Isometry3d::Identity(), map));
    beside.KeyFrameMade(key_frames.back().get());
    beside.wait_idle();
  }
  CHECK(beside.counts().processed == 1);
  CHECK(beside.counts().failed == 2);
  CHECK(beside.lost_key_frames() ==
        std::map<std::string, std::size_t>{{"the network is of another size", 2}});
  beside.stop();
}
