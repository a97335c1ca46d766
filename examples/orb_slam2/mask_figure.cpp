// SPDX-License-Identifier: MIT
// Draws which ORB features of an image the dynamic feature mask drops, and says how many.
#include <cstddef>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include <opencv2/features2d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <topobag/adaptors/opencv.hpp>
#include <topobag/sensing/dynamic_feature_mask.hpp>
#include <topobag/sensing/range_detections.hpp>

namespace {

using namespace topobag;

void draw_box(cv::Mat& picture, const BoundingBox& box) {
  cv::rectangle(picture, cv::Point2d(box.x1, box.y1), cv::Point2d(box.x2, box.y2),
                cv::Scalar(0, 200, 255), 2);
}

void run(const std::string& model, const std::string& rgb, const std::string& depth_file,
         double depth_scale, const std::string& out) {
  const cv::Mat image = cv::imread(rgb, cv::IMREAD_COLOR);
  const DepthImage depth(cv::imread(depth_file, cv::IMREAD_UNCHANGED), depth_scale);
  const ClassCatalog catalog = ClassCatalog::coco80();
  YoloDetector detect(model, catalog.ids());
  PinholeCamera<> camera;  // its image size alone matters here
  camera.width = image.cols;
  camera.height = image.rows;
  const auto detections = range_detections(detect(image), depth, camera);

  std::vector<cv::KeyPoint> features;
  cv::ORB::create(1000)->detect(image, features);
  const DynamicFeatureMask mask(detections, catalog);
  DynamicFeatureOptions whole_boxes;
  whole_boxes.reach = std::numeric_limits<double>::infinity();
  const DynamicFeatureMask box_mask(detections, catalog, whole_boxes);
  const DynamicFeatureMask papers(detections, catalog, DynamicFeatureOptions::paper());

  cv::Mat picture = image.clone();
  for (const RangedDetection& detection : detections) {
    if (detection.confidence >= DynamicFeatureOptions{}.min_confidence &&
        catalog.dynamics(detection.label) == Dynamics::high) {
      draw_box(picture, detection.box);
      std::cout << catalog.name(detection.label) << " at " << detection.z << " m, score "
                << detection.confidence << '\n';
    }
  }
  std::size_t dropped = 0, in_boxes = 0, by_paper = 0;
  for (const cv::KeyPoint& feature : features) {
    const Eigen::Vector2d pixel(feature.pt.x, feature.pt.y);
    const auto z = depth(pixel);
    const bool drop = mask(pixel, z);
    const bool in_box = box_mask(pixel, z);
    dropped += drop ? 1 : 0;
    in_boxes += in_box ? 1 : 0;
    by_paper += papers(pixel, z) ? 1 : 0;
    const cv::Scalar red(40, 40, 230), blue(230, 120, 0), green(60, 200, 60);
    cv::circle(picture, feature.pt, 3, drop ? red : in_box ? blue : green, 1, cv::LINE_AA);
  }
  const auto share = [&](std::size_t n) {
    return 100.0 * static_cast<double>(n) / static_cast<double>(features.size());
  };
  std::cout << features.size() << " features; dropped " << dropped << " (" << share(dropped)
            << " %), in dynamic boxes " << in_boxes << " (" << share(in_boxes)
            << " %), by the paper's sentence " << by_paper << " (" << share(by_paper) << " %)\n";
  if (!cv::imwrite(out, picture, {cv::IMWRITE_JPEG_QUALITY, 80})) {
    throw Error(out + ": the picture cannot be written");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::cerr << "mask_figure MODEL RGB DEPTH DEPTH_SCALE OUT\n";
    return 2;
  }
  try {
    run(argv[1], argv[2], argv[3], std::stod(argv[4]), argv[5]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
