// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

#include <opencv2/imgcodecs.hpp>

#include <topobag/adaptors/opencv.hpp>
#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"
#include "examples/scratch.hpp"

using namespace topobag;

TEST_CASE("a network that is none is told with its file", "[adaptors]") {
  CHECK_THROWS_AS(YoloDetector("no/such.onnx", {}), Error);
  const ScratchFolder folder;
  const std::string file = folder.write("no_network.onnx", "no network");
  CHECK(error_in(folder, [&] { YoloDetector(file, {}); }) ==
        "no_network.onnx: the file is not an ONNX network that OpenCV can read");
}

TEST_CASE("YOLOX-Nano finds the desk's monitor", "[adaptors][long]") {
  const char* const data = std::getenv("TOPOBAG_DATA");
  if (data == nullptr) {
    std::cout << "skipped: set TOPOBAG_DATA to the folder with models/ and tum/\n";
    return;
  }
  const std::string folder = data;
  const ClassCatalog catalog = ClassCatalog::coco80();
  YoloDetector detect(folder + "/models/yolox_nano.onnx", catalog.ids());
  const cv::Mat image = cv::imread(folder + "/tum/fr1_xyz/rgb/1305031102.175304.png");
  const auto found = detect(image);
  CHECK(std::any_of(found.begin(), found.end(), [&](const Detection& d) {
    return d.label == catalog.at("tv") && d.confidence > 0.5;
  }));
  CHECK_THROWS_AS(detect(cv::Mat()), InvalidValue);
}
