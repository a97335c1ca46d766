// SPDX-License-Identifier: MIT
#include "table_checks.hpp"

#include <random>
#include <string>
#include <utility>

#include "camera_option.hpp"
#include "catch.hpp"
#include "error_text.hpp"

namespace {

program::KeyframeOptions checked_options() {
  program::KeyframeOptions options;
  options.camera = {517.3, 516.5, 318.6, 255.3, 640, 480};
  return options;
}

/// A table of boxes around places that `draw` gives, each with a depth.
template <typename Draw>
program::NodeTable table_of_boxes(int boxes, Draw draw) {
  program::NodeTable table;
  table.frames.resize(1);
  for (int i = 0; i < boxes; ++i) {
    table.frames[0].detections.push_back({draw(), topobag::ClassId{41}, 0.9});
    table.frames[0].detections.back().z = 2.0;
  }
  return table;
}

template <typename Draw>
std::string said_of_boxes(int boxes, Draw draw) {
  const program::NodeTable table = table_of_boxes(boxes, draw);
  return error_text([&] { program::require_in_image("set", table, checked_options()); });
}

std::string said_of_camera(const topobag::PinholeCamera<>& given) {
  return error_text([&] { program::with_size(given, {640, 480}); });
}

}  // namespace

TEST_CASE("boxes of another image or another form are told", "[examples][regression]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto corners = [&] {
    const double x = 600.0 * share(random), y = 440.0 * share(random);
    return std::pair<Eigen::Vector2d, Eigen::Vector2d>{
        {x, y}, {x + (640.0 - x) * share(random), y + (480.0 - y) * share(random)}};
  };
  const auto whole = [&] {
    const auto [a, b] = corners();
    return topobag::BoundingBox{a.x(), a.y(), b.x(), b.y()};
  };
  const auto half = [&] {
    const auto [a, b] = corners();
    return topobag::BoundingBox{0.5 * a.x(), 0.5 * a.y(), 0.5 * b.x(), 0.5 * b.y()};
  };
  const auto mistaken = [&] {
    const auto [a, b] = corners();
    return topobag::box_around({a.x(), a.y()}, b.x(), b.y());
  };
  CHECK(said_of_boxes(200, whole) == "nothing was thrown");
  CHECK(said_of_boxes(20, half) == "nothing was thrown");  // too few to tell
  const std::string halved = said_of_boxes(200, half);
  CHECK(halved.find("set.nodes.csv: no box reaches beyond 3") == 0);
  CHECK(halved.find(" of the camera's image of 640 x 480 px; give --camera and --image-size of the "
                    "table's images") != std::string::npos);
  CHECK(said_of_boxes(200, mistaken)
            .find("u, v are a box's centre and w, h its size, not two "
                  "corners") != std::string::npos);
}

TEST_CASE("depths that are not in metres are told with their range", "[examples][regression]") {
  program::NodeTable table = table_of_boxes(4, [x = 0.0]() mutable {
    x += 100.0;
    return topobag::box_around({x, 200.0}, 50.0, 50.0);
  });
  for (auto& detection : table.frames[0].detections) detection.z = 800.0 + detection.box.x1;
  const auto said = [&](std::size_t keyframes) {
    const std::vector<program::Keyframe> none(keyframes);
    return error_text([&] { program::require_usable("set", table, none, checked_options()); });
  };
  CHECK(said(1).find("set.nodes.csv: none of the 1 key frames has three objects with a position; "
                     "of 4 detections in the table 0 are below") == 0);
  CHECK(said(1).find("4 are out of range") != std::string::npos);
  CHECK(said(1).find("; z are from 875 to 1175; are they in metres?") != std::string::npos);
  for (auto& detection : table.frames[0].detections) detection.z = 0.0;
  CHECK(said(1).find("are they in metres") == std::string::npos);
  table.frames.resize(61);
  CHECK(
      said(1).find("set.nodes.csv: none of the 1 key frames, which --keyframe-interval 0.4 leaves "
                   "of 61 frames, has three objects") == 0);
}

TEST_CASE("a focal length that is not in px is refused", "[examples][regression]") {
  CHECK(said_of_camera({517.3, 516.5, 318.6, 255.3}) == "nothing was thrown");
  CHECK(said_of_camera({80.0, 80.0, 318.6, 255.3}) == "nothing was thrown");      // 152 degrees
  CHECK(said_of_camera({5000.0, 5000.0, 318.6, 255.3}) == "nothing was thrown");  // a long lens
  const std::string px = "; give the focal length in px";
  CHECK(said_of_camera({3.6, 3.6, 320, 240}) ==
        "--camera: fx 3.6 px is a field of view of 178.7° over 640 px" + px);
  CHECK(said_of_camera({51730, 51650, 318.6, 255.3}) ==
        "--camera: fx 51730 px is a field of view of 0.7° over 640 px" + px);
  CHECK(said_of_camera({517.3, 5.165, 318.6, 255.3}).find("--camera: fy 5.165 px is a field") == 0);
}
