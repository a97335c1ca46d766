// SPDX-License-Identifier: MIT
// Node tables in place of a detector beside an ORB-SLAM, read by the sources that its program is
// linked of.
#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include <detectors.hpp>

#include "catch.hpp"
#include "scratch_folder.hpp"
#include "semantic_slam/small_calibration.hpp"

namespace {

/// A table of two frames: two boxes with depths, and none.
std::string small_table(const ScratchFolder& folder) {
  folder.write("set.frames.csv", "idx,frame,timestamp\n0,a.png,10.5\n1,b.png,11.5\n");
  folder.write("set.nodes.csv",
               "idx,class_id,class,conf,u,v,w,h,z\n"
               "0,56,chair,0.9,100,200,40,60,2.5\n0,62,tv,0.8,300,200,80,50,3.5\n");
  return folder.path("set");
}

semantic::TableRows rows_of(const ScratchFolder& folder) {
  return semantic::TableRows({small_table(folder)});
}

semantic::Images images_at(double stamp, const cv::Mat& depth) {
  semantic::Images images;
  images.stamp = stamp;
  images.depth = depth;
  return images;
}

}  // namespace

TEST_CASE("a node table answers for the images of its stamps", "[hooks][regression]") {
  const ScratchFolder folder;
  const semantic::Detect boxes = semantic::table_detector(rows_of(folder));
  const cv::Mat depth = cv::Mat::ones(4, 4, CV_16U);
  const auto found = boxes(images_at(10.5, depth));
  REQUIRE(found.size() == 2);
  CHECK(found[0].label == topobag::ClassId{56});
  CHECK(found[0].z == 2.5);
  CHECK(found[1].box.center() == Eigen::Vector2d(300.0, 200.0));
  CHECK(boxes(images_at(11.5, depth)).empty());
  CHECK(boxes(images_at(12.5, depth)).empty());
}

TEST_CASE("a table's depths are forgotten where an image comes without depth",
          "[hooks][regression]") {
  const ScratchFolder folder;
  const semantic::Detect boxes =
      semantic::undistorted(semantic::table_detector(rows_of(folder)), small_calibration());
  cv::Mat depth = cv::Mat::zeros(4, 4, CV_16U);
  auto found = boxes(images_at(10.5, depth));
  REQUIRE(found.size() == 2);
  CHECK(found[0].z == 0.0);
  CHECK(found[1].z == 0.0);
  CHECK(found[1].confidence == 0.8);
  depth.at<std::uint16_t>(2, 1) = 7;
  found = boxes(images_at(10.5, depth));
  REQUIRE(found.size() == 2);
  CHECK(found[0].z == 2.5);
  CHECK(found[1].z == 3.5);
}

TEST_CASE("tables of another sequence than the images' are refused", "[hooks][regression]") {
  const ScratchFolder folder;
  const semantic::TableRows rows = rows_of(folder);
  const auto said = [&rows](const std::vector<semantic::FramePaths>& frames) {
    try {
      rows.require_some_of(frames, "--kidnap-detections");
    } catch (const topobag::Error& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  CHECK(said({{11.5, "b.png", "b_depth.png"}}) == "nothing");  // it has no box, but a row
  CHECK(said({{9.0, "0.png", "0_depth.png"}, {10.500009, "a.png", "a_depth.png"}}) == "nothing");
  CHECK(said({}) == "nothing");
  CHECK(said({{10.6, "s/rgb/c.png", "s/depth/c.png"}}) ==
        "s/rgb/c.png: no table has this image, nor any other of its sequence; name the table of "
        "the sequence with --kidnap-detections");
}
