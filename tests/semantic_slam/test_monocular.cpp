// SPDX-License-Identifier: MIT
// Beside an ORB-SLAM of one camera: key frames get the depths of their map points, in the host's
// own unit; a lost frame has directions alone.
#include <deque>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include <detectors.hpp>
#include <host.hpp>
#include <semantic_slam.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"
#include "semantic_slam/small_calibration.hpp"

namespace {

/// A room, and one camera in it whose host's unit is 1 / `per_metre` m.
class MonocularRoom {
 public:
  explicit MonocularRoom(double units_per_metre) : per_metre(units_per_metre) {}

  /// The boxes of the image, without depths.
  std::vector<topobag::RangedDetection> boxes(double stamp) const {
    std::vector<topobag::RangedDetection> found;
    for (const auto& node : objects(stamp)) {
      const Eigen::Vector2d size = calibration.camera.fx / node.z * node.size;
      found.push_back({topobag::box_around(pixel(node), size.x(), size.y()),
                       topobag::ClassId{topobag::value(node.label) + 56}, 0.9});
    }
    return found;
  }

  Eigen::Isometry3d in_units(double stamp) const {
    Eigen::Isometry3d pose = cameras.at(stamp);
    pose.translation() *= per_metre;
    return pose;
  }

  /// A key frame with five map points on each object.
  std::unique_ptr<host::KeyFrame> key_frame(unsigned long id, double stamp) {
    auto made = std::make_unique<host::KeyFrame>(id, stamp, in_units(stamp), map);
    for (const auto& node : objects(stamp)) {
      const Eigen::Vector3d point = per_metre * (cameras.at(stamp) * *node.position);
      map_points.push_back({host::position(point)});
      for (int i = -2; i <= 2; ++i) {
        const Eigen::Vector2f at = pixel(node).cast<float>();
        made->mvKeysUn.emplace_back(cv::Point2f(at.x() + static_cast<float>(i), at.y()), 31.0F);
        made->map_points.push_back(&map_points.back());
      }
    }
    return made;
  }

  host::Frame frame(double stamp) const {
    host::Frame made(stamp);
    made.mvDepth.assign(20, -1.0F);
    return made;
  }

  const double per_metre;
  const semantic::Calibration calibration = small_calibration();
  std::map<double, Eigen::Isometry3d> cameras;  ///< by the stamp of the image, m
  host::Map map;

 private:
  std::vector<topobag::SemanticNode<>> objects(double stamp) const {
    return room.seen_from(cameras.at(stamp)).nodes();
  }
  Eigen::Vector2d pixel(const topobag::SemanticNode<>& node) const {
    return *calibration.camera.project(*node.position);
  }

  const SyntheticRoom room{4, 9, 9};
  std::deque<host::MapPoint> map_points;
};

std::unique_ptr<semantic::SemanticSlam> beside_one_camera(const MonocularRoom& room) {
  semantic::Settings settings;
  settings.camera = room.calibration.camera;
  settings.map_point_depths = true;
  return std::make_unique<semantic::SemanticSlam>(
      settings, topobag::ClassCatalog::coco80(),
      semantic::with_feature_depths(
          [&room](const semantic::Images& images) { return room.boxes(images.stamp); },
          room.calibration));
}

}  // namespace

TEST_CASE("one camera: a lost frame is found by directions, in the host's unit", "[hooks]") {
  const cv::Mat image = cv::Mat::zeros(4, 4, CV_8U);
  for (const double per_metre : {0.7, 1.0, 1.4}) {
    CAPTURE(per_metre);
    MonocularRoom room(per_metre);
    const auto semantic = beside_one_camera(room);
    std::mt19937 random(6);
    std::vector<std::unique_ptr<host::KeyFrame>> key_frames;
    for (unsigned long id = 1; id <= 3; ++id) {
      const auto stamp = static_cast<double>(id);
      room.cameras[stamp] = random_camera(random);
      host::Frame frame = room.frame(stamp);
      semantic->FrameMade(frame, image, {});
      key_frames.push_back(room.key_frame(id, stamp));
      semantic->KeyFrameMade(key_frames.back().get());
      semantic->Added(key_frames.back().get());
    }
    semantic->wait_idle();
    REQUIRE(semantic->size() == 3);
    room.cameras[20.0] = random_camera(random);
    host::Frame lost = room.frame(20.0);
    semantic->FrameMade(lost, image, {});
    std::vector<host::KeyFrame*> candidates;
    semantic->RelocalizationCandidates(&lost, candidates, nullptr);
    const semantic::OfferedPlaces offered = semantic->offered_places().back();
    CHECK(offered.by_bearings);
    REQUIRE(offered.T_world_camera);
    const Eigen::Isometry3d off = offered.T_world_camera->inverse() * room.in_units(20.0);
    CHECK(off.translation().norm() < 0.1);
    CHECK(semantic->failures().first == 0);
    semantic->stop();
  }
}

TEST_CASE("one camera: the first key frame's images are gone when it is made", "[hooks]") {
  const cv::Mat image = cv::Mat::zeros(4, 4, CV_8U);
  MonocularRoom room(1.0);
  const auto semantic = beside_one_camera(room);
  std::mt19937 random(6);
  room.cameras[1.0] = room.cameras[2.0] = random_camera(random);
  for (const double stamp : {1.0, 2.0}) {
    host::Frame frame = room.frame(stamp);
    semantic->FrameMade(frame, image, {});
  }
  const auto first = room.key_frame(1, 1.0), second = room.key_frame(2, 2.0);
  for (host::KeyFrame* key_frame : {first.get(), second.get()}) {
    semantic->KeyFrameMade(key_frame);
    semantic->Added(key_frame);
  }
  semantic->wait_idle();
  CHECK(semantic->size() == 1);
  CHECK(semantic->lost_key_frames() ==
        std::map<std::string, std::size_t>{{"its images are those of an earlier frame", 1}});
  semantic->stop();
}
