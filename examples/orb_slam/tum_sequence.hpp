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

namespace semantic {

/// Where the images of one moment are.
struct FramePaths {
  double stamp = 0.0;  ///< s
  std::string rgb, depth;
};

/// The pairs of images of a sequence. Throws topobag::Error when there are none.
inline std::vector<FramePaths> read_associations(const std::string& sequence,
                                                 const std::string& file) {
  std::vector<FramePaths> frames;
  std::istringstream lines(program::read_file(file));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    FramePaths frame;
    std::string depth_stamp;
    if (!(words >> frame.stamp >> frame.rgb >> depth_stamp >> frame.depth)) continue;
    frame.rgb = sequence + "/" + frame.rgb;
    frame.depth = sequence + "/" + frame.depth;
    frames.push_back(frame);
  }
  if (frames.empty()) throw topobag::Error(file + ": there are no images in it");
  return frames;
}

/// The images of one moment; both of a stereo pair in color, grey ones too, for whoever compares
/// them wants both alike. Throws topobag::Error when a file is not an image, or the images of a
/// stereo pair have not one size.
inline Images read_images(const FramePaths& frame, bool is_stereo) {
  const int second = is_stereo ? cv::IMREAD_COLOR : cv::IMREAD_UNCHANGED;
  Images images{cv::imread(frame.rgb, cv::IMREAD_COLOR), cv::imread(frame.depth, second),
                frame.stamp};
  if (images.rgb.empty()) throw topobag::Error(frame.rgb + ": the file is not an image");
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
