// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <iostream>

#include <opencv2/imgcodecs.hpp>

#include <topobag/adaptors/opencv.hpp>
#include <topobag/sensing/describe_detections.hpp>

#include "catch.hpp"
#include "examples/looks_on_tables.hpp"
#include "examples/sample.hpp"
#include "rgbd_sequence.hpp"

using program::NodeTable;

namespace {

/// The table with its objects described anew in images whose blue, green and red are multiplied,
/// rounded and clipped.
NodeTable in_other_light(NodeTable table, const program::RgbdSequence& images,
                         const cv::Scalar& factors) {
  for (std::size_t i = 0; i < table.frames.size(); ++i) {
    cv::Mat lit;
    cv::multiply(cv::imread(images.frames.at(i).rgb), factors, lit);
    const cv::Mat depth = cv::imread(images.frames[i].depth, cv::IMREAD_UNCHANGED);
    topobag::describe_detections(table.frames[i].detections, topobag::color_image(lit),
                                 topobag::DepthImage(depth, 5000.0));
  }
  return table;
}

}  // namespace

TEST_CASE("exposure and white balance of one side change few decisions",
          "[adaptors][appearance][long]") {
  const char* const data = std::getenv("TOPOBAG_DATA");
  if (data == nullptr) {
    std::cout << "skipped: set TOPOBAG_DATA to the folder with models/ and tum/\n";
    return;
  }
  const NodeTable map = program::read_node_table(sample_map);
  const NodeTable query = program::read_node_table(sample_query);
  const auto images = program::read_tum_sequence(std::string(data) + "/tum/fr1_rpy");
  const TableAnswers as_it_was = answers_of(map, in_other_light(query, images, {1, 1, 1}));
  for (const cv::Scalar& factors :
       {cv::Scalar(0.6, 0.6, 0.6), cv::Scalar(1.6, 1.6, 1.6), cv::Scalar(0.8, 1.0, 1.2),
        cv::Scalar(1.2, 1.0, 0.8), cv::Scalar(1.0, 0.8, 1.0)}) {
    const TableAnswers changed = answers_of(map, in_other_light(query, images, factors));
    std::size_t same = 0;
    for (std::size_t i = 0; i < changed.accepted.size(); ++i) {
      if (changed.accepted[i] == as_it_was.accepted[i]) ++same;
    }
    std::cout << "blue, green, red × " << factors[0] << ", " << factors[1] << ", " << factors[2]
              << ": " << same << " of " << changed.accepted.size() << " decisions the same, "
              << changed.found << " accepted\n";
    CAPTURE(factors[0], factors[1], factors[2]);
    CHECK(10 * same >= 9 * changed.accepted.size());
    CHECK(changed.wrong == 0);
  }
}
