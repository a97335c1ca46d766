// SPDX-License-Identifier: MIT
// What the looks of objects are worth on the sample data.
#include <algorithm>
#include <iostream>

#include "catch.hpp"
#include "looks_on_tables.hpp"
#include "sample.hpp"

using program::NodeTable;
using topobag::RangedDetection;

namespace {

NodeTable without_looks(NodeTable table) {
  for (auto& frame : table.frames) {
    for (RangedDetection& detection : frame.detections) detection.appearance = {};
  }
  return table;
}

/// The objects that stand on one side of a plane across a world's axis.
NodeTable half_of(NodeTable table, Eigen::Index axis, double middle, bool upper) {
  const topobag::PinholeCamera<> camera = fr1_single_frames().camera;
  for (auto& frame : table.frames) {
    auto& all = frame.detections;
    const auto elsewhere = [&](const RangedDetection& detection) {
      if (!(detection.z > 0.0)) return true;
      const Eigen::Vector2d pixel = detection.box.center();
      const Eigen::Vector3d there((pixel.x() - camera.cx) / camera.fx * detection.z,
                                  (pixel.y() - camera.cy) / camera.fy * detection.z, detection.z);
      return ((*frame.T_world_camera * there)[axis] > middle) != upper;
    };
    all.erase(std::remove_if(all.begin(), all.end(), elsewhere), all.end());
  }
  return table;
}

}  // namespace

TEST_CASE("looks find more of the desk, and nothing that is not there", "[examples][appearance]") {
  const NodeTable map = program::read_node_table(sample_map);
  const NodeTable query = program::read_node_table(sample_query);
  const TableAnswers plain = answers_of(without_looks(map), without_looks(query));
  const TableAnswers looks = answers_of(map, query);
  std::cout << "fr1_rpy in fr1_xyz, single frames: " << plain.found << " accepted, "
            << plain.correct << " correct without looks; " << looks.found << ", " << looks.correct
            << " with\n";
  CHECK(looks.correct > plain.correct);
  CHECK(looks.wrong == 0);
}

TEST_CASE("unlike halves of one desk are two places", "[examples][appearance]") {
  const NodeTable xyz = program::read_node_table(sample_map);
  const NodeTable rpy = program::read_node_table(sample_query);
  std::size_t whole = 0;
  // About the middle of the desk's objects, m.
  for (const auto& [axis, middle] : {std::pair<Eigen::Index, double>{0, 0.52}, {1, 0.70}}) {
    for (const bool upper : {false, true}) {
      CAPTURE(axis, upper);
      const NodeTable here = half_of(xyz, axis, middle, upper);
      CHECK(answers_of(here, half_of(rpy, axis, middle, !upper)).found == 0);
      whole += answers_of(here, half_of(rpy, axis, middle, upper)).found;
    }
  }
  CHECK(whole > 0);  // halves are enough where they are the same
}
