// SPDX-License-Identifier: MIT
#include <type_traits>

#include <topobag/adaptors/opencv.hpp>

#include "catch.hpp"

TEST_CASE("the OpenCV header brings all that needs OpenCV", "[adaptors]") {
  CHECK(std::is_class_v<topobag::DepthImage>);
  CHECK(std::is_class_v<topobag::Letterbox>);
  CHECK(std::is_class_v<topobag::YoloDetector>);
  CHECK(topobag::undistorted({}, cv::Mat(), cv::Mat()).empty());
}
