// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include <topobag/error.hpp>
#include <topobag/evaluation/trajectory.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>

#include <csv_reader.hpp>

#include "semantic_slam.hpp"
#include "sensor.hpp"

namespace semantic {

/// Where the images of one moment are.
struct FramePaths {
  double stamp = 0.0;      ///< s
  std::string rgb, depth;  ///< the second is a depth image, a right one, or none
};

/// The pairs of images of a sequence; of one camera the images alone, whatever more a line names.
/// Throws topobag::Error when there are none.
inline std::vector<FramePaths> read_associations(const std::string& sequence,
                                                 const std::string& file, Sensor sensor) {
  std::vector<FramePaths> frames;
  std::istringstream lines(program::read_file(file));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    FramePaths frame;
    std::string depth_stamp;
    if (!(words >> frame.stamp >> frame.rgb)) continue;
    frame.rgb = sequence + "/" + frame.rgb;
    if (sensor != Sensor::mono) {
      if (!(words >> depth_stamp >> frame.depth)) continue;
      frame.depth = sequence + "/" + frame.depth;
    }
    frames.push_back(frame);
  }
  if (frames.empty()) throw topobag::Error(file + ": there are no images in it");
  return frames;
}

/// The images of one moment; both of a stereo pair in color, grey ones too, for whoever compares
/// them wants both alike; one camera has no second. Throws topobag::Error when a file is not an
/// image, or the images of a stereo pair have not one size.
inline Images read_images(const FramePaths& frame, Sensor sensor) {
  Images images{cv::imread(frame.rgb, cv::IMREAD_COLOR), cv::Mat(), frame.stamp};
  if (images.rgb.empty()) throw topobag::Error(frame.rgb + ": the file is not an image");
  if (sensor == Sensor::mono) return images;
  const bool is_stereo = sensor == Sensor::stereo;
  images.depth = cv::imread(frame.depth, is_stereo ? cv::IMREAD_COLOR : cv::IMREAD_UNCHANGED);
  if (images.depth.empty()) throw topobag::Error(frame.depth + ": the file is not an image");
  if (is_stereo && images.depth.size() != images.rgb.size()) {
    throw topobag::Error(frame.depth + ": the right image has not the size of the left one, " +
                         frame.rgb);
  }
  return images;
}

/// The truth of a sequence where it is at hand.
inline topobag::Trajectory read_truth(const std::string& sequence) {
  const std::string path = sequence + "/groundtruth.txt";
  return std::ifstream(path) ? topobag::read_tum(path) : topobag::Trajectory{};
}

/// The same where there is nothing to do without it. Throws topobag::Error where it is not at hand.
inline topobag::Trajectory required_truth(const std::string& sequence) {
  topobag::Trajectory truth = read_truth(sequence);
  if (truth.empty()) {
    throw topobag::Error(sequence +
                         "/groundtruth.txt: there are no poses to score a kidnapped camera by");
  }
  return truth;
}

/// Nothing where the truth has a gap of more than 0.1 s, or is not at hand.
inline std::optional<Eigen::Isometry3d> true_pose(const topobag::Trajectory& truth, double stamp) {
  return topobag::pose_at(truth, stamp, 0.1, topobag::RotationInterpolation::slerp);
}

}  // namespace semantic
