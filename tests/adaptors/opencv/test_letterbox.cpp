// SPDX-License-Identifier: MIT
#include <opencv2/core.hpp>

#include <topobag/adaptors/opencv/letterbox.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a letterboxed image fills its place, the rest is grey", "[adaptors]") {
  const cv::Mat image(50, 100, CV_8UC3, cv::Scalar::all(7));
  const Letterbox corner(image, 40, Letterbox::Place::upper_left);
  const Letterbox middle(image, 40, Letterbox::Place::center);
  CHECK(corner.input().size() == cv::Size(40, 40));
  CHECK(corner.input().at<cv::Vec3b>(19, 39)[0] == 7);
  CHECK(corner.input().at<cv::Vec3b>(20, 0)[0] == 114);
  CHECK(middle.input().at<cv::Vec3b>(9, 0)[0] == 114);
  CHECK(middle.input().at<cv::Vec3b>(10, 0)[0] == 7);
  CHECK(middle.input().at<cv::Vec3b>(30, 0)[0] == 114);
}

TEST_CASE("boxes come back into the image", "[adaptors]") {
  const cv::Mat image(50, 100, CV_8UC3, cv::Scalar::all(7));
  // The whole input is the whole image and grey; the image spans -0.5 to 99.5.
  for (const auto place : {Letterbox::Place::upper_left, Letterbox::Place::center}) {
    const BoundingBox all = Letterbox(image, 40, place).in_image({0.0, 0.0, 40.0, 40.0});
    CHECK(all.x1 == Approx(-0.5));
    CHECK(all.x2 == Approx(99.5));
    CHECK(all.y1 == Approx(-0.5));
    CHECK(all.y2 == Approx(49.5));
  }
  const BoundingBox box =
      Letterbox(image, 40, Letterbox::Place::center).in_image({10.0, 14.0, 20.0, 22.0});
  CHECK(box.x1 == Approx(24.5));
  CHECK(box.y1 == Approx(9.5));
  CHECK(box.x2 == Approx(49.5));
  CHECK(box.y2 == Approx(29.5));
  CHECK_FALSE(Letterbox(image, 40, Letterbox::Place::upper_left)
                  .in_image({0.0, 30.0, 40.0, 39.0})
                  .is_valid());
  CHECK_THROWS_AS(Letterbox(cv::Mat(), 40, Letterbox::Place::center), InvalidValue);
}
