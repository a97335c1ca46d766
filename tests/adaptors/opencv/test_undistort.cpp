// SPDX-License-Identifier: MIT
#include <limits>
#include <vector>

#include <opencv2/core.hpp>

#include <topobag/adaptors/opencv/undistort.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("boxes move to where a straight camera sees their centres", "[adaptors]") {
  const cv::Mat camera = (cv::Mat_<double>(3, 3) << 500, 0, 320, 0, 500, 240, 0, 0, 1);
  const cv::Mat distortion = (cv::Mat_<double>(4, 1) << 0.1, 0.0, 0.0, 0.0);
  // The point (0.5, 0.2) before the camera, distorted by 1 + 0.1 r².
  const double factor = 1.0 + 0.1 * (0.25 + 0.04);
  const Eigen::Vector2d straight(570.0, 340.0);
  const Eigen::Vector2d seen(320.0 + 250.0 * factor, 240.0 + 100.0 * factor);
  RangedDetection detection{box_around(seen, 30.0, 20.0), ClassId{1}, 0.5, 2.0};
  RangedDetection broken = detection;
  broken.box.x1 = std::numeric_limits<double>::quiet_NaN();
  const auto moved = undistorted({broken, detection}, camera, distortion);
  REQUIRE(moved.size() == 2);
  CHECK_FALSE(moved[0].box.is_valid());
  CHECK((moved[1].box.center() - straight).norm() < 0.05);
  CHECK(moved[1].box.width() == Approx(30.0));
  CHECK(moved[1].z == 2.0);
  CHECK(undistorted({}, camera, distortion).empty());
  const auto same = undistorted({detection}, camera, cv::Mat());
  CHECK((same[0].box.center() - seen).norm() < 1e-6);
}

TEST_CASE("what the image's border cuts is cut without distortion, too", "[adaptors][regression]") {
  const cv::Mat camera = (cv::Mat_<double>(3, 3) << 500, 0, 320, 0, 500, 240, 0, 0, 1);
  const cv::Mat distortion = (cv::Mat_<double>(4, 1) << 0.3, 0.0, 0.0, 0.0);  // draws inwards
  const BoundingBox whole{40.0, 30.0, 600.0, 450.0};
  for (const BoundingBox& box : {BoundingBox{0.0, 200.0, 60.0, 260.0},
                                 {1.9, 0.0, 60.0, 50.0},
                                 {500.0, 300.0, 639.0, 479.0},
                                 {570.0, 100.0, 637.1, 170.0},
                                 {300.0, 420.0, 360.0, 477.1},
                                 whole}) {
    CAPTURE(box.x1, box.y1, box.x2, box.y2);
    const RangedDetection seen{box, ClassId{1}, 0.5, 2.0};
    const BoundingBox plain = undistorted({seen}, camera, distortion).at(0).box;
    const BoundingBox moved = undistorted({seen}, camera, distortion, {640, 480}).at(0).box;
    CHECK(moved.x1 == (box.x1 < 2.0 ? 0.0 : plain.x1));
    CHECK(moved.y1 == (box.y1 < 2.0 ? 0.0 : plain.y1));
    CHECK(moved.x2 == (box.x2 > 637.0 ? 639.0 : plain.x2));
    CHECK(moved.y2 == (box.y2 > 477.0 ? 479.0 : plain.y2));
  }
}
