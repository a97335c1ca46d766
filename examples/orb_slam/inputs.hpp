// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <topobag/evaluation/trajectory.hpp>
#include <topobag/matching/scale_range.hpp>

#include "arguments.hpp"
#include "detectors.hpp"
#include "semantic_slam.hpp"
#include "table_rows.hpp"
#include "tum_sequence.hpp"

namespace semantic {

/// What the program reads before the host begins with its vocabulary: what can be wrong with the
/// user's files and arguments shows here. Throws topobag::Error with the reason.
struct Inputs {
  explicit Inputs(const Arguments& arguments)
      : sensor(sensor_of(arguments)),
        depth(depth_of(arguments)),
        calibration(read_calibration(arguments.settings)),
        frames(read_associations(arguments.sequence, arguments.associations, sensor)) {
    if (!arguments.kidnap_sequence.empty()) {
      kidnap_frames =
          read_associations(arguments.kidnap_sequence, arguments.kidnap_associations, sensor);
      required_truth(arguments.sequence);  // by which the map is laid onto the truth
      kidnap_truth = required_truth(arguments.kidnap_sequence);
    }
    if (arguments.stock) return;
    know_image_size();
    detect = make_detect(arguments);
  }

  /// Of what stands beside the host.
  Settings settings(const Arguments& arguments) const {
    Settings settings;
    settings.camera = calibration.camera;
    settings.database.fusing.window = arguments.window;
    settings.database.max_relocalizations = arguments.max_places;
    topobag::RecognitionOptions& recognition = settings.database.recognition;
    if (arguments.candidates > 0) recognition.retrieval.max_results = arguments.candidates;
    if (sensor == Sensor::mono) {
      settings.map_point_depths = true;
      recognition.matching.scale = topobag::ScaleRange{};  // its maps' units drift and differ
    }
    settings.lost_window = arguments.kidnap_window;
    if (arguments.still > 0.0) {
      settings.still.emplace();
      settings.still->max_motion = arguments.still;
    }
    if (arguments.mask) settings.mask = topobag::DynamicFeatureOptions{};
    return settings;
  }

  Sensor sensor;
  std::string depth;  ///< as `depth_of` says
  Calibration calibration;
  std::vector<FramePaths> frames;
  std::vector<FramePaths> kidnap_frames;  ///< that are shown to the lost tracker
  topobag::Trajectory kidnap_truth;
  Detect detect;  ///< none beside a stock host

 private:
  /// By it boxes are seen to be cut, and views to hold an object. ORB-SLAM2's settings of one
  /// camera do not say it.
  void know_image_size() {
    topobag::PinholeCamera<>& camera = calibration.camera;
    if (camera.width > 0 && camera.height > 0) return;
    const cv::Mat image = read_images(frames.front(), sensor).rgb;
    camera.width = image.cols;
    camera.height = image.rows;
  }

  Detect make_detect(const Arguments& arguments) const {
    const bool has_table = arguments.model.empty();
    const Detect boxes =
        has_table ? boxes_of_tables(arguments) : network_detector(arguments.model, calibration);
    if (depth == "points") return with_feature_depths(boxes, calibration);
    if (depth == "stereo") return with_disparities(boxes, calibration);
    return has_table ? undistorted(boxes, calibration) : with_depth_image(boxes, calibration);
  }

  /// The boxes of the tables, which have to be those of the sequences.
  Detect boxes_of_tables(const Arguments& arguments) const {
    std::vector<std::string> tables{arguments.table};
    if (!arguments.kidnap_table.empty()) tables.push_back(arguments.kidnap_table);
    TableRows rows(tables);
    rows.require_some_of(frames, "--detections");
    rows.require_some_of(kidnap_frames, "--kidnap-detections");
    return table_detector(std::move(rows));
  }
};

}  // namespace semantic
