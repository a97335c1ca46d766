// SPDX-License-Identifier: MIT
// Key frames whose view hardly changed are not looked at, and nobody waits for their objects.
#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include <host.hpp>
#include <semantic_slam.hpp>

#include <topobag/error.hpp>

#include "catch.hpp"

namespace {

/// A camera that goes along x, with a detector that finds nothing.
class StillCamera {
 public:
  explicit StillCamera(bool is_skipping = true) {
    semantic::Settings settings;
    settings.camera = {400.0, 400.0, 319.5, 239.5, 640, 480};
    settings.database.loop_wait = std::chrono::hours(1);  // whoever waits hangs
    if (is_skipping) settings.still.emplace();
    semantic = std::make_unique<semantic::SemanticSlam>(
        settings, topobag::ClassCatalog::coco80(),
        [this](const semantic::Images&) -> std::vector<topobag::RangedDetection> {
          ++looks_;
          if (fails) throw topobag::Error("it fails");
          return {};
        });
  }
  ~StillCamera() { semantic->stop(); }

  /// Whether the detector looks at a key frame there.
  bool is_looked_at(double stamp, double x, host::Map& map) {
    const std::size_t before = looks_;
    host::Frame frame(stamp);
    semantic->FrameMade(frame, image_, image_);
    Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
    T_world_camera.translation().x() = x;
    key_frames.push_back(
        std::make_unique<host::KeyFrame>(key_frames.size() + 1, stamp, T_world_camera, map));
    host::KeyFrame* const made = key_frames.back().get();
    semantic->KeyFrameMade(made);
    std::vector<host::KeyFrame*> candidates;
    semantic->LoopCandidates(made, candidates);
    semantic->Added(made);
    semantic->wait_idle();
    return looks_ > before;
  }

  std::vector<std::unique_ptr<host::KeyFrame>> key_frames;
  std::unique_ptr<semantic::SemanticSlam> semantic;
  bool fails = false;

 private:
  const cv::Mat image_ = cv::Mat::zeros(4, 4, CV_8U);
  std::size_t looks_ = 0;  ///< read when the topology thread is idle
};

}  // namespace

TEST_CASE("key frames of a still view are not looked at, nor waited for", "[hooks]") {
  host::Map map;
  StillCamera camera;
  CHECK(camera.is_looked_at(1.0, 0.0, map));
  CHECK_FALSE(camera.is_looked_at(1.5, 0.05, map));
  CHECK_FALSE(camera.is_looked_at(2.0, 0.09, map));
  CHECK(camera.is_looked_at(2.5, 0.11, map));
  CHECK_FALSE(camera.is_looked_at(3.0, 0.11, map));
  CHECK(camera.is_looked_at(8.0, 0.11, map));  // older than 5 s
  CHECK(camera.semantic->lost_key_frames() ==
        std::map<std::string, std::size_t>{{"the view hardly changed", 3}});
  CHECK(camera.semantic->counts().pushed == 3);
  CHECK(camera.semantic->failures().first == 0);

  StillCamera every(false);
  CHECK(every.is_looked_at(1.0, 0.0, map));
  CHECK(every.is_looked_at(1.5, 0.0, map));
}

TEST_CASE("a still view is looked at again when the last look is of no use", "[hooks]") {
  host::Map map, other;
  StillCamera camera;
  camera.fails = true;
  CHECK(camera.is_looked_at(1.0, 0.0, map));
  camera.fails = false;
  CHECK(camera.is_looked_at(1.2, 0.0, map));
  CHECK_FALSE(camera.is_looked_at(1.4, 0.0, map));
  camera.semantic->Erased(camera.key_frames.back().get());  // it was not looked at
  CHECK_FALSE(camera.is_looked_at(1.6, 0.0, map));
  camera.semantic->Erased(camera.key_frames[1].get());
  CHECK(camera.is_looked_at(1.8, 0.0, map));
  CHECK(camera.is_looked_at(2.0, 0.0, other) == topobag::has_maps_v<host::KeyFrame>);
  camera.semantic->Cleared();
  CHECK(camera.is_looked_at(2.2, 0.0, other));
}
