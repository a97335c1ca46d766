// SPDX-License-Identifier: MIT
#include <random>
#include <string>
#include <vector>

#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"
#include "keyframe_graphs.hpp"
#include "node_table.hpp"
#include "random_label_weights.hpp"
#include "scratch.hpp"

using namespace program;

namespace {

const std::string labelled_frame = "idx,frame,timestamp\n0,a.png,1.0\n";
const std::string labelled_header = "idx,class,conf,u,v,w,h,z";

/// A table with these rows behind `0,cup,`.
std::string labelled_table(const ScratchFolder& folder, const std::string& column,
                           const std::string& labels) {
  folder.write("s.frames.csv", labelled_frame);
  folder.write("s.nodes.csv",
               labelled_header + column + "\n0,cup,0.5,100,100,40,40,1" + labels + "\n");
  return folder.path("s");
}

topobag::LabelWeights labels_of(const std::string& column, const std::string& labels) {
  const ScratchFolder folder;
  return read_node_table(labelled_table(folder, column, labels))
      .frames.at(0)
      .detections.at(0)
      .label_weights;
}

std::string error_of_labels(const std::string& labels) {
  const ScratchFolder folder;
  const std::string set = labelled_table(folder, ",labels", "," + labels);
  return error_in(folder, [&] { read_node_table(set); });
}

}  // namespace

TEST_CASE("a table may say what else its objects may be", "[examples]") {
  const auto catalog = topobag::ClassCatalog::coco80();
  const topobag::ClassId cup = catalog.at("cup"), bowl = catalog.at("bowl"),
                         glass = catalog.at("wine glass");
  CHECK(labels_of(",labels", ",cup=0.6|bowl=0.3|wine glass=0.1") ==
        topobag::LabelWeights({{cup, 0.6}, {bowl, 0.3}, {glass, 0.1}}));
  CHECK(labels_of(",labels", ", bowl = 2 | cup = 3 ") ==
        topobag::LabelWeights({{cup, 3.0}, {bowl, 2.0}}));
  CHECK(labels_of(",labels", ",").empty());
  CHECK(labels_of("", "").empty());
}

TEST_CASE("what a table says of labels comes back as it was written, and goes into the graphs",
          "[examples]") {
  std::mt19937 random(1);
  const ScratchFolder folder;
  NodeTable table = read_node_table(labelled_table(folder, "", ""));
  write_node_table(folder.path("plain"), table);
  CHECK(read_file(folder.path("plain.nodes.csv")).find("labels") == std::string::npos);
  auto& detections = table.frames[0].detections;
  for (int i = 0; i < 20; ++i) {
    detections.push_back(detections[0]);
    detections.back().label = topobag::ClassId{41 + i};
    detections.back().box = topobag::box_around({60.0 + 25.0 * i, 200.0}, 20.0, 20.0);
    if (i % 3 > 0) {
      detections.back().label_weights = random_label_weights(random, detections.back().label);
    }
  }
  write_node_table(folder.path("t"), table);
  const NodeTable back = read_node_table(folder.path("t"));
  REQUIRE(back.frames[0].detections.size() == detections.size());
  for (std::size_t i = 0; i < detections.size(); ++i) {
    CHECK(back.frames[0].detections[i].label_weights == detections[i].label_weights);
  }
  KeyframeOptions options;
  options.camera = {500.0, 500.0, 320.0, 240.0, 640, 480};
  options.window = 0.0;
  std::size_t weighted = 0;
  for (const auto& keyframe : read_keyframes(folder.path("t"), options)) {
    for (const auto& node : keyframe.graph.nodes()) {
      weighted += node.label_weights.empty() ? 0U : 1U;
    }
  }
  CHECK(weighted > 5);
}

TEST_CASE("labels that say nothing clear are refused with the line", "[examples]") {
  CHECK(error_of_labels("cup=0.6|saucer=0.4").find("s.nodes.csv:2: unknown class 'saucer'") == 0);
  const std::string unclear = "' are not written as class=weight|class=weight";
  CHECK(error_of_labels("cup|bowl") == "s.nodes.csv:2: labels 'cup|bowl" + unclear);
  CHECK(error_of_labels("cup=0.6|") == "s.nodes.csv:2: labels 'cup=0.6|" + unclear);
  CHECK(error_of_labels("cup=much") == "s.nodes.csv:2: labels 'cup=much" + unclear);
  CHECK(error_of_labels("cup=-1|bowl=0.1")
            .find("s.nodes.csv:2: label 0 has a weight that is no number from 0 on") == 0);
  CHECK(error_of_labels("cup=0.3|bowl=0.6") ==
        "s.nodes.csv:2: labels 'cup=0.3|bowl=0.6' give another class than 'cup' the most weight");
}
