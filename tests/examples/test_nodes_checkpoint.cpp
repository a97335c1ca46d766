// SPDX-License-Identifier: MIT
#include "nodes_checkpoint.hpp"

#include <filesystem>

#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

namespace {

using program::NodesCheckpoint;

const std::vector<program::RgbdFrame> images{{1.0 / 3.0, "rgb/1.png", "", {}},
                                             {2.0 / 3.0, "rgb/2.png", "", {}}};

const topobag::ClassCatalog checkpoint_classes = topobag::ClassCatalog::coco80();

/// The first image, with one detection, and two boxes outside of it.
program::DetectedNodes first_image() {
  program::DetectedNodes detected;
  detected.table.frames = {program::row_of(images[0], 0)};
  topobag::RangedDetection tv;
  tv.label = topobag::ClassId{62};
  tv.confidence = 0.5;
  tv.box = topobag::box_around({10.0, 20.0}, 4.0, 6.0);
  tv.z = 1.5;
  detected.table.frames[0].detections = {tv};
  detected.outside = 2;
  return detected;
}

}  // namespace

TEST_CASE("a run of nodes goes on from what an earlier one kept", "[examples]") {
  const ScratchFolder folder;
  const std::string set = folder.path("set");
  CHECK(NodesCheckpoint(set, "a").earlier(images).table.frames.empty());
  NodesCheckpoint now(set, "a", checkpoint_classes, std::chrono::seconds(0));
  now.keep(first_image());
  const auto kept = NodesCheckpoint(set, "a").earlier(images);
  REQUIRE(kept.table.frames.size() == 1);
  CHECK(kept.outside == 2);
  CHECK(kept.table.frames[0].timestamp == images[0].timestamp);  // to the last digit
  CHECK(kept.table.frames[0].detections.at(0).z == 1.5);
  now.remove();
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("the table so far is kept when it is time to", "[examples]") {
  const ScratchFolder folder;
  NodesCheckpoint(folder.path("set"), "a", checkpoint_classes, std::chrono::hours(1)).keep(first_image());
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("what other options or images made, or is not whole, is no beginning", "[examples]") {
  const ScratchFolder folder;
  const std::string set = folder.path("set");
  const auto rows = [&](const std::string& made_with, const std::vector<program::RgbdFrame>& of) {
    return NodesCheckpoint(set, made_with).earlier(of).table.frames.size();
  };
  NodesCheckpoint(set, "a", checkpoint_classes, std::chrono::seconds(0)).keep(first_image());
  CHECK(rows("a", images) == 1);
  CHECK(rows("b", images) == 0);
  CHECK(rows("a", {}) == 0);
  CHECK(rows("a", {images[1]}) == 0);
  const std::string nodes = content_of(set + ".partial.nodes.csv");
  folder.write("set.partial.nodes.csv",
               nodes.substr(0, nodes.find('\n') + 1));  // of another moment
  CHECK(rows("a", images) == 0);
  folder.write("set.partial.json", "{");
  CHECK(rows("a", images) == 0);
}

TEST_CASE("what an earlier run kept is not written over by another one", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string set = folder.path("set");
  const auto said = [&](const std::string& made_with, const std::vector<program::RgbdFrame>& of) {
    return error_text([&] { NodesCheckpoint(set, made_with).require_own(of); });
  };
  CHECK(said("a", images) == "nothing was thrown");
  NodesCheckpoint(set, "a", checkpoint_classes, std::chrono::seconds(0)).keep(first_image());
  const std::string other =
      set + ".partial.json: an earlier run with other options, or of other images, kept 1 frames; "
            "give what it was given to go on, delete " +
      set + ".partial.* to begin anew, or give another --out";
  CHECK(said("a", images) == "nothing was thrown");
  CHECK(said("b", images) == other);
  CHECK(said("a", {images[1]}) == other);
  const std::string nodes = content_of(set + ".partial.nodes.csv");
  folder.write("set.partial.nodes.csv", nodes.substr(0, nodes.find('\n') + 1));
  CHECK(said("a", images) == "nothing was thrown");  // of another moment: nothing to go on with
  folder.write("set.partial.json", "{");
  CHECK(said("a", images) == "nothing was thrown");
}
