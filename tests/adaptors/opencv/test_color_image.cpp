// SPDX-License-Identifier: MIT
#include <opencv2/core.hpp>

#include <topobag/adaptors/opencv.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a colour image is read in place, a part of one too", "[opencv]") {
  cv::Mat image(4, 6, CV_8UC3, cv::Scalar(0, 0, 0));
  image.at<cv::Vec3b>(2, 3) = {10, 20, 30};
  const ImageView bgr = color_image(image);
  CHECK(bgr.width() == 6);
  CHECK(bgr.height() == 4);
  CHECK(bgr(3, 2) == ImageView::Color{30, 20, 10});
  CHECK(color_image(image, ColorOrder::rgb)(3, 2) == ImageView::Color{10, 20, 30});
  const cv::Mat part = image(cv::Rect(2, 1, 3, 3));
  CHECK(color_image(part)(1, 1) == ImageView::Color{30, 20, 10});
  image.at<cv::Vec3b>(2, 3) = {1, 2, 3};
  CHECK(bgr(3, 2) == ImageView::Color{3, 2, 1});
  const cv::Mat with_alpha(2, 2, CV_8UC4, cv::Scalar(1, 2, 3, 4));
  CHECK(color_image(with_alpha)(1, 1) == ImageView::Color{3, 2, 1});
}

TEST_CASE("what is no colour image is refused by OpenCV's type", "[opencv]") {
  CHECK_THROWS_AS(color_image(cv::Mat(2, 2, CV_8UC1)), InvalidValue);
  CHECK_THROWS_AS(color_image(cv::Mat(2, 2, CV_16UC3)), InvalidValue);
  CHECK_THROWS_AS(color_image(cv::Mat()), InvalidValue);
  CHECK_THROWS_AS(color_image(cv::Mat(0, 0, CV_8UC3)), InvalidValue);
}
