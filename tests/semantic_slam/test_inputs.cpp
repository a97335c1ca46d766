// SPDX-License-Identifier: MIT
// What the program beside an ORB-SLAM takes from its arguments and the user's files.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <inputs.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

namespace {

/// A sequence of two images without truth, a table of it, and settings.
struct SmallSequence {
  SmallSequence() {
    arguments.settings = folder.write(
        "settings.yaml",
        "%YAML:1.0\nCamera.fx: 500.0\nCamera.fy: 500.0\nCamera.cx: 319.5\nCamera.cy: 239.5\n"
        "Camera.width: 640\nCamera.height: 480\nDepthMapFactor: 5000.0\n");
    arguments.sequence = folder.path("sequence");
    arguments.associations = folder.write("rgb.txt", "# images\n10.5 rgb/a.png\n11.5 rgb/b.png\n");
    folder.write("set.frames.csv", "idx,frame,timestamp\n0,a.png,10.5\n1,b.png,11.5\n");
    folder.write("set.nodes.csv",
                 "idx,class_id,class,conf,u,v,w,h,z\n0,56,chair,0.9,100,200,40,60,2.5\n");
    arguments.table = folder.path("set");
  }

  std::string refusal() const {
    return error_text([this] { semantic::Inputs inputs(arguments); });
  }

  ScratchFolder folder;
  semantic::Arguments arguments;
};

semantic::Arguments arguments_of(const std::string& sensor, const std::string& depth) {
  semantic::Arguments arguments;
  arguments.sensor = sensor;
  arguments.depth = depth;
  return arguments;
}

}  // namespace

TEST_CASE("a sensor has its own depths, or those of the host's points", "[hooks]") {
  using semantic::Sensor;
  struct Case {
    std::string sensor, depth;
    Sensor is;
    std::string has;
  };
  for (const Case& given : {Case{"", "", Sensor::rgbd, "rgbd"},
                            {"", "points", Sensor::rgbd, "points"},
                            {"", "stereo", Sensor::stereo, "stereo"},
                            {"rgbd", "", Sensor::rgbd, "rgbd"},
                            {"stereo", "", Sensor::stereo, "stereo"},
                            {"stereo", "points", Sensor::stereo, "points"},
                            {"mono", "", Sensor::mono, "points"},
                            {"mono", "points", Sensor::mono, "points"}}) {
    CAPTURE(given.sensor, given.depth);
    const semantic::Arguments arguments = arguments_of(given.sensor, given.depth);
    CHECK(semantic::sensor_of(arguments) == given.is);
    CHECK(semantic::depth_of(arguments) == given.has);
  }
  for (const auto& [sensor, depth] : {std::pair{"rgbd", "stereo"}, std::pair{"stereo", "rgbd"},
                                      std::pair{"mono", "rgbd"}, std::pair{"mono", "stereo"}}) {
    CHECK_THROWS_AS(semantic::depth_of(arguments_of(sensor, depth)), topobag::Error);
  }
  CHECK(error_text([] { semantic::depth_of(arguments_of("mono", "stereo")); }) ==
        "--sensor mono has no --depth stereo: give points, or leave it out");
  CHECK(error_text([] { semantic::depth_of(arguments_of("rgbd", "stereo")); }) ==
        "--sensor rgbd has no --depth stereo: give rgbd or points, or leave it out");
}

TEST_CASE("one camera's images come without a second, and its unit is not known", "[hooks]") {
  SmallSequence given;
  given.arguments.sensor = "mono";
  const semantic::Inputs inputs(given.arguments);
  REQUIRE(inputs.frames.size() == 2);
  CHECK(inputs.frames[1].stamp == 11.5);
  CHECK(inputs.frames[1].rgb == given.folder.path("sequence") + "/rgb/b.png");
  CHECK(inputs.frames[1].depth.empty());
  const semantic::Settings settings = inputs.settings(given.arguments);
  CHECK(settings.map_point_depths);
  CHECK(settings.database.recognition.matching.scale);

  // Of the detector's boxes those have a depth in which points of the host are.
  semantic::Images images;
  images.stamp = 10.5;
  REQUIRE(inputs.detect(images).size() == 1);
  CHECK(inputs.detect(images)[0].z == 0.0);
  for (int i = 0; i < 3; ++i) images.points.push_back({{95.0 + 5.0 * i, 200.0}, 1.25});
  CHECK(inputs.detect(images)[0].z == 1.25);

  const semantic::FramePaths frame{1.5, given.folder.path("a.png"), ""};
  REQUIRE(cv::imwrite(frame.rgb, cv::Mat::zeros(4, 6, CV_8UC1)));
  const semantic::Images read = semantic::read_images(frame, semantic::Sensor::mono);
  CHECK(read.rgb.size() == cv::Size(6, 4));
  CHECK(read.depth.empty());
}

TEST_CASE("a host in metres keeps its scale, and pairs of images have both", "[hooks]") {
  SmallSequence given;
  CHECK(given.refusal() == given.arguments.associations + ": there are no images in it");
  given.folder.write("rgb.txt", "10.5 rgb/a.png 10.4 depth/a.png\n");
  const semantic::Inputs inputs(given.arguments);
  REQUIRE(inputs.frames.size() == 1);
  CHECK(inputs.frames[0].depth == given.folder.path("sequence") + "/depth/a.png");
  const semantic::Settings settings = inputs.settings(given.arguments);
  CHECK_FALSE(settings.map_point_depths);
  CHECK_FALSE(settings.database.recognition.matching.scale);
  CHECK_FALSE(settings.still);
  given.arguments.still = 0.2;
  REQUIRE(inputs.settings(given.arguments).still);
  CHECK(inputs.settings(given.arguments).still->max_motion == 0.2);
  given.arguments.depth = "stereo";
  CHECK(given.refusal().find("--depth stereo needs the distance of the two cameras") == 0);
  given.arguments.stock = true;
  CHECK_FALSE(semantic::Inputs(given.arguments).detect);
}

TEST_CASE("the frames of a kidnapped camera are read with their truth and their table", "[hooks]") {
  SmallSequence given;
  given.arguments.sensor = "mono";
  given.arguments.kidnap_sequence = given.folder.path();
  given.arguments.kidnap_associations = given.folder.write("shown.txt", "20.5 c.png\n");
  CHECK(given.refusal().find("sequence/groundtruth.txt: there are no poses") != std::string::npos);
  given.arguments.sequence = given.folder.path();
  given.folder.write("groundtruth.txt", "20.5 0 0 0 0 0 0 1\n");
  CHECK(given.refusal().find("name the table of the sequence with --kidnap-detections") !=
        std::string::npos);
  given.folder.write("shown.frames.csv", "idx,frame,timestamp\n0,c.png,20.5\n");
  given.folder.write("shown.nodes.csv", "idx,class_id,class,conf,u,v,w,h,z\n");
  given.arguments.kidnap_table = given.folder.path("shown");
  const semantic::Inputs inputs(given.arguments);
  CHECK(inputs.kidnap_frames.size() == 1);
  CHECK(inputs.kidnap_truth.size() == 1);
}

TEST_CASE("the image size that settings do not say is that of the images", "[hooks][regression]") {
  SmallSequence given;
  given.arguments.sensor = "mono";
  given.arguments.settings = given.folder.write(
      "mono.yaml",
      "%YAML:1.0\nCamera.fx: 500.0\nCamera.fy: 500.0\nCamera.cx: 319.5\nCamera.cy: 239.5\n");
  std::filesystem::create_directories(given.folder.path("sequence/rgb"));
  REQUIRE(cv::imwrite(given.folder.path("sequence/rgb/a.png"), cv::Mat::zeros(48, 64, CV_8UC3)));
  const semantic::Inputs inputs(given.arguments);
  CHECK(inputs.calibration.camera.width == 64);
  CHECK(inputs.calibration.camera.height == 48);
  CHECK(inputs.settings(given.arguments).camera.width == 64);
}
