// SPDX-License-Identifier: MIT
#include "typical_sizes.hpp"

#include <cmath>
#include <random>
#include <string>

#include "catch.hpp"
#include "keyframe_graphs.hpp"
#include "object_classes.hpp"
#include "scratch.hpp"

using namespace program;

TEST_CASE("a depth with which an object would be of no size of its class is not believed",
          "[examples]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.01, 1.0);
  const topobag::PinholeCamera<> camera{500.0, 400.0, 320.0, 240.0, 640, 480};
  const topobag::ClassId pallet{0}, crate{1};
  const TypicalSizes sizes{{pallet, {1.2, 0.15}}};
  std::vector<FrameRow> frames(20), before;
  for (FrameRow& frame : frames) {
    for (int i = 0; i < 30; ++i) {
      topobag::RangedDetection detection;
      detection.label = i % 3 == 0 ? crate : pallet;
      detection.box =
          topobag::box_around({320.0, 240.0}, 400.0 * unit(random), 300.0 * unit(random));
      detection.z = i % 7 == 0 ? 0.0 : 12.0 * unit(random);
      frame.detections.push_back(detection);
    }
  }
  before = frames;
  disbelieve_depths(camera, {}, frames);
  disbelieve_depths(camera, sizes, frames);
  std::size_t disbelieved = 0, believed = 0;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    for (std::size_t i = 0; i < 30; ++i) {
      const auto &was = before[f].detections[i], &is = frames[f].detections[i];
      const double width = was.box.width() * was.z / 500.0,
                   height = was.box.height() * was.z / 400.0;
      const double factor =
          std::sqrt((width * width + height * height) / (1.2 * 1.2 + 0.15 * 0.15));
      const bool fits = was.label == crate || was.z == 0.0 || (factor <= 4.0 && factor >= 0.25);
      CHECK(is.z == (fits ? was.z : 0.0));
      if (was.label == pallet && was.z > 0.0) ++(fits ? believed : disbelieved);
    }
  }
  CHECK(believed > 20);
  CHECK(disbelieved > 20);
}

TEST_CASE("typical sizes of a file of classes are read, and used where tables are", "[examples]") {
  const ScratchFolder folder;
  KeyframeOptions options;
  options.classes = read_object_classes(
      folder.write("c.txt", "pallet, low, , 1.2 x 0.15\ncrate, medium, pallet, 0.6x0.4\ndrum\n"));
  CHECK(options.classes.sizes ==
        TypicalSizes{{topobag::ClassId{0}, {1.2, 0.15}}, {topobag::ClassId{1}, {0.6, 0.4}}});
  options.camera = {500.0, 500.0, 320.0, 240.0, 640, 480};
  options.window = 0.0;
  options.matchable = false;
  folder.write("s.frames.csv", "idx,frame,timestamp\n0,a.png,1.0\n");
  folder.write("s.nodes.csv",
               "idx,class,conf,u,v,w,h,z\n"
               "0,crate,0.9,100,100,200,200,1.5\n0,crate,0.9,400,300,200,200,9\n"
               "0,drum,0.9,300,100,200,200,9\n");
  const auto keyframes = read_keyframes(folder.path("s"), options);
  REQUIRE(keyframes.size() == 1);
  CHECK(keyframes[0].graph.size() == 2);  // not the crate of 3.6 m
}

TEST_CASE("typical sizes that are none are refused with the line", "[examples]") {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& size) {
    return error_in(folder, [&] {
      read_object_classes(folder.write("c.txt", "drum\ncrate, low, drum, " + size + "\n"));
    });
  };
  for (const std::string size : {"1.2", "1.2 x", "wide x high", "0 x 1", "1 x -1", "1 x 2 x 3"}) {
    CHECK(refused(size) ==
          "c.txt:2: the typical size '" + size + "' is no width x height in metres");
  }
}
