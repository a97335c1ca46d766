// SPDX-License-Identifier: MIT
#include "usual_sizes.hpp"

#include <string>
#include <vector>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

const topobag::PinholeCamera<> sized_camera{517.3, 516.5, 318.6, 255.3, 640, 480};

/// The sample's frames with every depth times a factor.
std::vector<program::FrameRow> scaled_frames(double factor) {
  auto frames = program::read_node_table(sample_map, topobag::ClassCatalog::coco80()).frames;
  for (auto& frame : frames) {
    for (auto& detection : frame.detections) detection.z *= factor;
  }
  return frames;
}

std::string doubt_of(double factor) {
  return program::size_doubt_text(scaled_frames(factor), sized_camera,
                                  topobag::ClassCatalog::coco80(), 0.3, "are z in metres");
}

}  // namespace

TEST_CASE("depths in another unit are told by how large things would be",
          "[examples][regression]") {
  const auto catalog = topobag::ClassCatalog::coco80();
  const auto once = program::size_factor(scaled_frames(1.0), sized_camera, catalog, 0.3);
  REQUIRE(once);
  CHECK(*once > 0.6);
  CHECK(*once < 1.7);
  const auto feet = program::size_factor(scaled_frames(3.2808), sized_camera, catalog, 0.3);
  REQUIRE(feet);
  CHECK(*feet == Approx(3.2808 * *once));
  CHECK(doubt_of(1.0).empty());
  CHECK(doubt_of(1.5).empty());
  for (const double factor : {3.2808, 5.0, 0.2, 0.1}) {
    const std::string doubt = doubt_of(factor);
    CHECK(doubt.find("times as large as things of their classes are, in the median: are z in "
                     "metres, and the focal length that of the images?") != std::string::npos);
  }
  CHECK_FALSE(program::size_factor({}, sized_camera, catalog, 0.3));
}

TEST_CASE("a table of another unit of length is told of, one of an unknown unit is not",
          "[examples][regression]") {
  const ScratchFolder folder;
  program::NodeTable table =
      program::read_node_table(sample_query, topobag::ClassCatalog::coco80());
  for (auto& frame : table.frames) {
    for (auto& detection : frame.detections) detection.z *= 3.2808;
  }
  const std::string set = folder.path("feet");
  program::write_node_table(set, table, topobag::ClassCatalog::coco80());
  const std::string command = "localize --map " + sample_map + " --query " + set + sample_options;
  const ProgramRun told = run_program(command + "--window 0");
  CHECK(told.exit_code == 0);
  CHECK(told.err.find("topobag: " + set + ": objects are ") == 0);
  CHECK(told.err.find("are z in metres") != std::string::npos);
  CHECK(run_program(command + "--window 0 --unknown-scale").err.empty());
  CHECK(run_program("localize --map " + sample_map + " --query " + sample_query + sample_options)
            .err.empty());
}
