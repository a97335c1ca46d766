// SPDX-License-Identifier: MIT
#include <opencv2/core.hpp>

#include <topobag/adaptors/opencv/depth_image.hpp>

#include "catch.hpp"

using namespace topobag;

static_assert(is_depth_source_v<DepthImage>);

TEST_CASE("depth images of integers and of floats are read, and parts of them", "[adaptors]") {
  cv::Mat integers(4, 6, CV_16UC1, cv::Scalar(0));
  integers.at<std::uint16_t>(2, 3) = 5000;
  CHECK(DepthImage(integers, 5000.0)({3.2, 1.8}) == 1.0);
  CHECK_FALSE(DepthImage(integers, 5000.0)({1.0, 1.0}));
  CHECK(DepthImage(integers(cv::Rect(2, 1, 3, 3)), 5000.0)({1.0, 1.0}) == 1.0);
  cv::Mat floats(4, 6, CV_32FC1, cv::Scalar(2.5));
  CHECK(DepthImage(floats, 1.0)({0.0, 0.0}) == 2.5);
  CHECK_FALSE(DepthImage(floats, 1.0)({9.0, 0.0}));
}

TEST_CASE("a depth image outlives the Mat it was made from", "[adaptors]") {
  cv::Mat image(2, 2, CV_32FC1, cv::Scalar(3.0));
  const DepthImage depth(image, 1.0);
  image = cv::Mat();
  CHECK(depth({1.0, 1.0}) == 3.0);
}

TEST_CASE("other images are refused", "[adaptors]") {
  CHECK_THROWS_AS(DepthImage(cv::Mat(2, 2, CV_8UC3), 1.0), InvalidValue);
  CHECK_THROWS_AS(DepthImage(cv::Mat(2, 2, CV_32FC1), 0.0), InvalidValue);
  CHECK_THROWS_AS(DepthImage(cv::Mat(), 1.0), InvalidValue);
}
