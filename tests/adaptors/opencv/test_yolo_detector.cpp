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
#include "tiny_network.hpp"

using namespace topobag;

TEST_CASE("a network that is none is told with its file", "[adaptors]") {
  CHECK_THROWS_AS(YoloDetector("no/such.onnx", {}), Error);
  const ScratchFolder folder;
  const std::string file = folder.write("no_network.onnx", "no network");
  CHECK(error_in(folder, [&] { YoloDetector(file, {}); }) ==
        "no_network.onnx: the file is not an ONNX network that OpenCV can read");
}

TEST_CASE("a layer's features in a box describe its object", "[adaptors][appearance]") {
  const ScratchFolder folder;
  YoloOptions options;
  options.head = YoloHead::yolov5;
  options.input_size = 32;
  // The upper right quarter of the input; the image is twice as large.
  const std::string model = folder.write("tiny.onnx", tiny_yolov5(24, 8, 16, 16));
  YoloDetector detect(model, {ClassId{7}}, options);
  cv::Mat image(64, 64, CV_8UC3, cv::Scalar(10, 10, 10));
  image(cv::Rect(32, 0, 32, 32)).setTo(cv::Scalar(10, 10, 250));  // red, as BGR
  const auto plain = detect(image);
  const auto found = detect.described(image, "features");
  REQUIRE(plain.size() == 1);
  REQUIRE(found.size() == 1);
  CHECK(found[0].box.x1 == plain[0].box.x1);
  CHECK(found[0].box.y2 == plain[0].box.y2);
  CHECK(found[0].box.x1 == 31.5);
  CHECK(found[0].label == ClassId{7});
  CHECK(found[0].confidence == plain[0].confidence);
  CHECK(found[0].z == 0.0);
  // Red, green, blue less the image's: a quarter of it is red.
  const AppearanceKind kind(detect.appearance_name("features"), 3);
  const Eigen::Vector3d red(240.0 - 60.0, 0.0, 0.0);
  REQUIRE(found[0].appearance.kind() == kind);
  CHECK(cosine_similarity(found[0].appearance, Appearance(kind, red)) > 0.999);
  CHECK(detect.appearance_name("features").find("layer:features@") == 0);
  const std::string other = folder.write("other.onnx", tiny_yolov5(8, 8, 16, 16));
  CHECK(YoloDetector(other, {ClassId{7}}, options).appearance_name("features") !=
        detect.appearance_name("features"));
  CHECK(error_in(folder, [&] {
          detect.described(image, "neck");
        }).find("tiny.onnx: the network has no layer 'neck' among its ") == 0);
  CHECK(error_in(folder, [&] { detect.described(image, "boxes"); }) ==
        "tiny.onnx: the layer 'boxes' puts out no map of features");
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
