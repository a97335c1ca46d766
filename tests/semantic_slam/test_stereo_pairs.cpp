// SPDX-License-Identifier: MIT
// A rectified stereo pair beside an ORB-SLAM: as it is read, and the depths of its disparities.
#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <detectors.hpp>
#include <tum_sequence.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"
#include "semantic_slam/small_calibration.hpp"

namespace {

/// A box of each half of the image.
std::vector<topobag::RangedDetection> box_of_each_half(const semantic::Images&) {
  return {{{100, 100, 300, 380}, topobag::ClassId{56}, 0.9},
          {{350, 100, 550, 380}, topobag::ClassId{62}, 0.8}};
}

/// Texture on two planes, 20 and 10 px apart in the images: 2.5 m and 5 m; grey.
semantic::Images two_planes() {
  cv::Mat texture(480, 700, CV_8UC1);
  cv::RNG random(4);
  random.fill(texture, cv::RNG::UNIFORM, 0, 255);
  cv::GaussianBlur(texture, texture, {5, 5}, 1.0);
  semantic::Images images;
  images.rgb = texture(cv::Rect(0, 0, 640, 480)).clone();
  images.depth = images.rgb.clone();
  texture(cv::Rect(20, 0, 320, 480)).copyTo(images.depth(cv::Rect(0, 0, 320, 480)));
  texture(cv::Rect(330, 0, 320, 480)).copyTo(images.depth(cv::Rect(320, 0, 320, 480)));
  return images;
}

void check_depths(const semantic::Images& images) {
  const auto ranged = semantic::with_disparities(box_of_each_half, small_calibration())(images);
  REQUIRE(ranged.size() == 2);
  CHECK(ranged[0].z == Approx(2.5).epsilon(0.02));
  CHECK(ranged[1].z == Approx(5.0).epsilon(0.02));
}

}  // namespace

TEST_CASE("boxes get the depths of a rectified pair's disparities", "[hooks]") {
  check_depths(two_planes());
}

TEST_CASE("what is near the left border has the depth of its disparities, too",
          "[hooks][regression]") {
  const auto at_border = [](const semantic::Images&) {
    return std::vector<topobag::RangedDetection>{{{24, 100, 104, 380}, topobag::ClassId{56}, 0.9}};
  };
  const auto ranged = semantic::with_disparities(at_border, small_calibration())(two_planes());
  REQUIRE(ranged.size() == 1);
  CHECK(ranged[0].z == Approx(2.5).epsilon(0.02));

  // What the right image does not show has none: 20 px there.
  const semantic::Images images = two_planes();
  const cv::Ptr<cv::StereoSGBM> matcher = cv::StereoSGBM::create(0, 128, 5, 200, 800);
  const cv::Mat disparity = semantic::disparities(images.rgb, images.depth, *matcher);
  REQUIRE(disparity.size() == images.rgb.size());
  for (int column = 0; column < 128; ++column) {
    double most = 0.0;
    cv::minMaxLoc(disparity.col(column), nullptr, &most);
    CHECK(most <= 16.0 * column);
  }
}

TEST_CASE("a grey stereo pair is read alike, and has the same depths", "[hooks][regression]") {
  const ScratchFolder folder;
  const semantic::Images made = two_planes();
  const semantic::FramePaths paths{1.5, folder.path("left.png"), folder.path("right.png")};
  REQUIRE(cv::imwrite(paths.rgb, made.rgb));
  REQUIRE(cv::imwrite(paths.depth, made.depth));
  const semantic::Images images = semantic::read_images(paths, semantic::Sensor::stereo);
  CHECK(images.stamp == 1.5);
  CHECK(images.rgb.type() == CV_8UC3);
  CHECK(images.depth.type() == CV_8UC3);
  check_depths(images);
}

TEST_CASE("a depth image is read as it is", "[hooks]") {
  const ScratchFolder folder;
  const semantic::FramePaths paths{1.5, folder.path("color.png"), folder.path("depth.png")};
  REQUIRE(cv::imwrite(paths.rgb, cv::Mat::zeros(4, 6, CV_8UC3)));
  REQUIRE(cv::imwrite(paths.depth, cv::Mat(4, 6, CV_16UC1, 5000)));
  const semantic::Images images = semantic::read_images(paths, semantic::Sensor::rgbd);
  REQUIRE(images.depth.type() == CV_16UC1);
  CHECK(images.depth.at<std::uint16_t>(2, 3) == 5000);
}

TEST_CASE("images that make no pair are refused with the file's name", "[hooks]") {
  const ScratchFolder folder;
  const semantic::FramePaths paths{1.5, folder.path("left.png"), folder.path("right.png")};
  REQUIRE(cv::imwrite(paths.rgb, cv::Mat::zeros(4, 6, CV_8UC1)));
  const auto said = [&paths](semantic::Sensor sensor) {
    return error_text([&] { semantic::read_images(paths, sensor); });
  };
  CHECK(said(semantic::Sensor::stereo) == paths.depth + ": the file is not an image");
  REQUIRE(cv::imwrite(paths.depth, cv::Mat::zeros(4, 5, CV_8UC1)));
  CHECK(said(semantic::Sensor::stereo) ==
        paths.depth + ": the right image has not the size of the left one, " + paths.rgb);
  CHECK(said(semantic::Sensor::rgbd) ==
        "nothing was thrown");  // the host takes depth images of its own size
}

TEST_CASE("a stereo camera's settings have to name its baseline", "[hooks][regression]") {
  const ScratchFolder folder;
  const std::string camera =
      "%YAML:1.0\nCamera.fx: 500.0\nCamera.fy: 500.0\nCamera.cx: 319.5\nCamera.cy: 239.5\n"
      "Camera.width: 640\nCamera.height: 480\n";
  const auto baseline = [&](const std::string& more) {
    folder.write("settings.yaml", camera + more);
    const auto calibration = semantic::read_calibration(folder.path("settings.yaml"));
    semantic::with_disparities(box_of_each_half, calibration);
    return calibration.baseline;
  };
  CHECK(baseline("Camera.bf: 60.0\n") == Approx(0.12));
  CHECK(baseline("Stereo.b: 0.11\n") == Approx(0.11));
  for (const char* none : {"", "Camera.bf: 0.0\n", "Stereo.b: -0.11\n"}) {
    CAPTURE(none);
    CHECK(error_text([&] { baseline(none); }).find("the settings have no positive one") !=
          std::string::npos);
  }
}
