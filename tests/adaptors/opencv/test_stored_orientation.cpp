// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "catch.hpp"
#include "detect_nodes.hpp"
#include "scratch_folder.hpp"

namespace {

/// A JPEG of 16 × 8 px whose EXIF tag asks for a quarter turn.
std::string turned_jpeg() {
  std::vector<unsigned char> plain;
  cv::imencode(".jpg", cv::Mat(8, 16, CV_8UC3, cv::Scalar(40, 80, 120)), plain);
  const std::string start(plain.begin(), plain.begin() + 2), rest(plain.begin() + 2, plain.end());
  const std::string orientation("\x12\x01\x03\0\x01\0\0\0\x06\0\0\0", 12);  // tag, short, one, 6
  const std::string exif =
      std::string("Exif\0\0II*\0\x08\0\0\0\x01\0", 16) + orientation + std::string(4, '\0');
  const auto length = static_cast<char>(exif.size() + 2);
  return start + "\xFF\xE1" + std::string(1, '\0') + length + exif + rest;
}

}  // namespace

TEST_CASE("colour is taken as it is stored, as depth is, whatever EXIF asks for",
          "[adaptors][regression]") {
  const ScratchFolder folder;
  const std::string rgb = folder.write("rgb.jpg", turned_jpeg());
  REQUIRE(cv::imread(rgb, cv::IMREAD_COLOR).cols == 8);  // what EXIF asks for
  cv::imwrite(folder.path("depth.png"), cv::Mat(8, 16, CV_16UC1, cv::Scalar(2000)));
  program::DetectionSource source;
  source.boxes.emplace();
  source.boxes->of_image = {{{topobag::box_around({8, 4}, 4, 4), topobag::ClassId{62}, 0.9}}};
  const program::ImageSize size = program::size_of_image(rgb);
  const topobag::PinholeCamera<> camera{20, 20, 8, 4, size.width, size.height};
  const program::RgbdFrame frame{1.0, rgb, folder.path("depth.png"), {}};
  program::NodesCheckpoint checkpoint(folder.path("set"), "");
  const auto detected = program::detect_nodes({frame}, source, 1000.0, camera, checkpoint);
  CHECK(size.width == 16);
  CHECK(detected.table.frames.at(0).detections.at(0).z == 2.0);
}
