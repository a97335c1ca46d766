// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

#include <detectors.hpp>
#include <feature_depths.hpp>
#include <host.hpp>

#include "catch.hpp"
#include "semantic_slam/small_calibration.hpp"
#include "semantic_slam/small_frame.hpp"

namespace {

/// A box of each half of the image, with a depth that is to be forgotten.
std::vector<topobag::RangedDetection> two_boxes(const semantic::Images&) {
  return {{{100, 100, 300, 380}, topobag::ClassId{56}, 0.9, 9.0},
          {{350, 100, 550, 380}, topobag::ClassId{62}, 0.8, 9.0}};
}

}  // namespace

TEST_CASE("the features whose depth the host knows", "[hooks]") {
  SmallFrame frame(1.0);
  frame.mvDepth.assign(20, -1.0F);
  CHECK(semantic::feature_depths(frame).empty());
  frame.mvDepth[3] = 2.5F;
  frame.mvDepth[4] = 0.0F;
  frame.mvDepth[7] = 4.0F;
  const auto points = semantic::feature_depths(frame);
  REQUIRE(points.size() == 2);
  CHECK(points[0].pixel == Eigen::Vector2d(90.0, 240.0));
  CHECK(points[0].z == 2.5);
  CHECK(points[1].pixel == Eigen::Vector2d(210.0, 240.0));
  CHECK(points[1].z == 4.0);
}

TEST_CASE("the features of a monocular key frame have the depths of its map points", "[hooks]") {
  host::Map map;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.linear() << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // looks along the world's x axis
  T_world_camera.translation() << 1.0, 2.0, 3.0;
  host::KeyFrame key_frame(1, 1.0, T_world_camera, map);
  CHECK(semantic::map_point_depths(key_frame).empty());
  host::MapPoint seen{host::position({3.5, 2.5, 3.0})};
  host::MapPoint nearer{host::position({2.0, 2.0, 4.0})};
  host::MapPoint behind{host::position({0.5, 2.0, 3.0})};
  host::MapPoint bad{host::position({4.0, 2.0, 3.0}), true};
  key_frame.map_points = {nullptr, &seen, &bad, &behind, &nearer, nullptr};
  for (int i = 0; i < 6; ++i) {
    key_frame.mvKeysUn.emplace_back(cv::Point2f(static_cast<float>(30 * i), 240.0F), 31.0F);
  }
  const auto points = semantic::map_point_depths(key_frame);
  REQUIRE(points.size() == 2);
  CHECK(points[0].pixel == Eigen::Vector2d(30.0, 240.0));
  CHECK(points[0].z == Approx(2.5));
  CHECK(points[1].pixel == Eigen::Vector2d(120.0, 240.0));
  CHECK(points[1].z == Approx(1.0));
}

TEST_CASE("boxes get the depths of the host's features in them, and of no others", "[hooks]") {
  semantic::Images images;
  for (int i = 0; i < 10; ++i) images.points.push_back({{150.0 + 10.0 * i, 240.0}, 2.0});
  for (int i = 0; i < 4; ++i) images.points.push_back({{150.0 + 10.0 * i, 200.0}, 5.0});  // behind
  images.points.push_back({{450.0, 240.0}, 3.0});                                         // too few
  const auto ranged = semantic::with_feature_depths(two_boxes, small_calibration())(images);
  REQUIRE(ranged.size() == 2);
  CHECK(ranged[0].z == 2.0);
  CHECK(ranged[0].label == topobag::ClassId{56});
  CHECK(ranged[0].confidence == 0.9);
  CHECK(ranged[1].z == 0.0);
}
