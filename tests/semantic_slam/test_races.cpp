// SPDX-License-Identifier: MIT
// The threads of the program beside an ORB-SLAM, on a small front end: compiled once for a host of
// one map and once for a host of several.
#include <chrono>
#include <memory>
#include <thread>

#include <topobag/sensing/dynamic_feature_mask.hpp>

#include "catch.hpp"
#include "long_rounds.hpp"
#include "semantic_slam/small_slam.hpp"

namespace {

std::unique_ptr<semantic::SemanticSlam> beside(SmallSlam& slam) {
  semantic::Settings settings;
  settings.camera = SmallSlam::camera();
  settings.database.loop_wait = std::chrono::milliseconds(1);
  settings.database.min_loop_gap = 0.0;
  settings.mask = topobag::DynamicFeatureOptions{};
  settings.still.emplace();
  auto beside = std::make_unique<semantic::SemanticSlam>(
      settings, topobag::ClassCatalog::coco80(),
      [&slam](const semantic::Images& images) { return slam.detect(images.stamp); });
  if (!SmallSlam::several) beside->hold_poses_with(slam.map_mutex());
  return beside;
}

/// Observers come late and go while the front end works; the last goes after the end was asked for.
/// They stop before they go: nobody tells them afterwards which key frames are deleted.
void race(std::chrono::milliseconds duration) {
  SmallSlam slam;
  std::size_t exceptions = 0;
  for (int observer = 0; observer < 4; ++observer) {
    const auto semantic = beside(slam);
    slam.hooks().SetObserver(semantic.get());
    std::this_thread::sleep_for(duration / 4);
    semantic->stop();
    if (observer == 3) slam.request_end();
    slam.hooks().SetObserver(nullptr);
    exceptions += semantic->failures().first;
    if (observer < 3) continue;
    const auto counts = semantic->counts();
    CHECK(counts.pushed == counts.processed + counts.failed + counts.given_up);
    CHECK(counts.failed == 0);
    CHECK(counts.processed > 0);
  }
  slam.shut_down();
  CHECK(exceptions == 0);
  CHECK(slam.candidates() > 0);
  CHECK(slam.places() > 0);
}

}  // namespace

TEST_CASE("an ORB-SLAM's threads and those of the semantic map", "[hooks]") {
  race(std::chrono::milliseconds(800));
}

TEST_CASE("the same threads for half a minute", "[hooks][long]") {
  race(std::chrono::milliseconds(long_rounds(30000)));
}
