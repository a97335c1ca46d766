// SPDX-License-Identifier: MIT
// ORB-SLAM2's hook that tries a lost frame at the places of the objects, on types of our own.
#include <cstddef>
#include <vector>

#include <RelocalizeFromPlaces.h>

#include "catch.hpp"

namespace {

/// A place whose key frame has so many points, and what is told of it.
struct PlaceOfPoints {
  explicit PlaceOfPoints(std::size_t count) : points(count) {
    for (ORB_SLAM2::MapPoint& point : points) key_frame.points.push_back(&point);
    frame.N = 60;
  }

  std::vector<topobag_hooks::Place<ORB_SLAM2::KeyFrame>> RelocalizationPlaces() {
    topobag_hooks::Place<ORB_SLAM2::KeyFrame> place{&key_frame, {}, 1.0F};
    for (std::size_t i = 0; i < 4; ++i) place.Tcw[5 * i] = 1.0F;
    place.Tcw[3] = 2.0F;
    return {place};
  }
  void PlacesTried(int accepted) { tried.push_back(accepted); }

  std::vector<ORB_SLAM2::MapPoint> points;
  ORB_SLAM2::KeyFrame key_frame;
  ORB_SLAM2::Frame frame;
  std::vector<int> tried;
};

}  // namespace

TEST_CASE("ORB-SLAM2: a lost frame gets the pose of its place, refined by RANSAC", "[hooks]") {
  PlaceOfPoints few(54), many(55);
  CHECK(topobag_hooks::RelocalizeFromPlaces(few, few.frame));
  CHECK(few.tried == std::vector<int>{0});
  CHECK(few.frame.mTcw.at<float>(0, 3) == 2.0F);
  CHECK(topobag_hooks::RelocalizeFromPlaces(many, many.frame));
  CHECK(many.frame.mTcw.at<float>(0, 3) == 3.0F);
  CHECK(many.frame.mTcw.at<float>(1, 1) == 1.0F);
}

TEST_CASE("ORB-SLAM2: a frame that is at no place is left without a pose", "[hooks]") {
  PlaceOfPoints none(49);
  CHECK_FALSE(topobag_hooks::RelocalizeFromPlaces(none, none.frame));
  CHECK(none.tried == std::vector<int>{-1});
  CHECK(none.frame.mTcw.empty());
}
