// SPDX-License-Identifier: MIT
// For how many key frames the program beside an ORB-SLAM3 has merge candidates, and the host too.
#include <memory>
#include <random>
#include <vector>

#include <opencv2/core.hpp>

#include <host.hpp>
#include <semantic_slam.hpp>

#include "catch.hpp"
#include "semantic_slam/seen_room.hpp"

TEST_CASE("key frames with merge candidates are counted: the host's, the bag's, and both",
          "[hooks]") {
  std::mt19937 random(6);
  SeenRoom seen;
  const cv::Mat image = cv::Mat::zeros(4, 4, CV_8U);
  semantic::Settings settings;
  settings.camera = seen.camera;
  bool sees_objects = true;
  semantic::SemanticSlam beside(
      settings, topobag::ClassCatalog::coco80(), [&](const semantic::Images& images) {
        return sees_objects ? seen.detect(images.stamp) : std::vector<topobag::RangedDetection>{};
      });
  host::Map first, second;
  std::vector<std::unique_ptr<host::KeyFrame>> key_frames;
  const auto make = [&](unsigned long id, host::Map& map) {
    const double stamp = 100.0 * static_cast<double>(id);
    seen.cameras[stamp] = random_camera(random);
    host::Frame frame(stamp);
    beside.FrameMade(frame, image, image);
    key_frames.push_back(std::make_unique<host::KeyFrame>(id, stamp, seen.cameras[stamp], map));
    beside.KeyFrameMade(key_frames.back().get());
    beside.wait_idle();
    return key_frames.back().get();
  };
  host::KeyFrame* const known = make(1, first);
  beside.Added(known);
  unsigned long id = 2;
  for (const bool of_bag : {true, false}) {
    sees_objects = of_bag;
    for (const bool of_host : {true, false}) {
      host::KeyFrame* const asked = make(id++, second);
      std::vector<host::KeyFrame*> candidates;
      if (of_host) candidates.push_back(known);
      beside.MergeCandidates(asked, candidates);
      CHECK(candidates.empty() == !(of_bag || of_host));
      if (of_bag && of_host) beside.MergeCandidates(asked, candidates);  // once more
    }
  }
  const semantic::MergeQueries queries = beside.merge_queries();
  CHECK(queries.asked == 5);
  CHECK(queries.of_host == 3);
  CHECK(queries.of_bag == 3);
  CHECK(queries.of_both == 2);
  CHECK(beside.failures().first == 0);
  beside.stop();
}
