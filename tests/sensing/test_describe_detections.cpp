// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <topobag/sensing/color_descriptor.hpp>
#include <topobag/sensing/describe_detections.hpp>
#include <topobag/sensing/lift_detections.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "sensing/painted_image.hpp"

using namespace topobag;

TEST_CASE("every detection gets its object's colours, and its node keeps them",
          "[sensing][appearance]") {
  PaintedImage image(1);
  image.paint(20, 40, 60, 80, {160, 40, 40});
  std::vector<RangedDetection> detections(2);
  detections[0] = {{20, 40, 59, 79}, ClassId{41}, 0.9, 1.0};
  detections[1] = {{100, 40, 139, 79}, ClassId{41}, 0.9, 2.0};
  const auto depth = [](const Eigen::Vector2d& pixel) -> std::optional<double> {
    return pixel.x() < 50 ? 1.0 : 2.0;
  };
  describe_detections(detections, image.view(), depth);
  const ColorDescriptor describe(image.view());
  for (const RangedDetection& d : detections) {
    CHECK(d.appearance.known());
    CHECK(d.appearance == describe(d.box, depth, d.z));
  }
  const PinholeCamera<> camera{100, 100, 99.5, 74.5, PaintedImage::width, PaintedImage::height};
  const auto lifted = lift_detections(detections, camera, ClassCatalog::coco80());
  REQUIRE(lifted.nodes.size() == 2);
  CHECK(lifted.nodes[0].appearance == detections[0].appearance);
  CHECK(lifted.nodes[1].appearance == detections[1].appearance);
}

TEST_CASE("depth of another size is refused before anything is described",
          "[sensing][appearance]") {
  const PaintedImage image(1);
  const std::vector<std::uint16_t> pixels(100, 1);
  const DepthView<std::uint16_t> depth(pixels.data(), 10, 10, 1.0);
  std::vector<RangedDetection> detections{{{20, 40, 59, 79}, ClassId{41}, 0.9, 1.0}};
  const std::string said =
      error_text([&] { describe_detections(detections, image.view(), depth); });
  CHECK(said ==
        "the depth image is 10 x 10 px, the camera's image 200 x 150: register the depth to the "
        "image first");
  CHECK_FALSE(detections[0].appearance.known());
}
