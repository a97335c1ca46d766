// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

/// The features of an ORB-SLAM's frame, on a type of our own: some on every part of the image.
struct SmallFrame {
  explicit SmallFrame(double stamp) : mTimeStamp(stamp) {
    for (int i = 0; i < N; ++i) {
      mvKeys.emplace_back(cv::Point2f(static_cast<float>(30 * i), 240.0F), 31.0F);
      mGrid[static_cast<std::size_t>(i) / 10][0].push_back(static_cast<std::size_t>(i));
    }
    mvKeysUn = mvKeys;
    mDescriptors = cv::Mat::zeros(N, 32, CV_8U);
  }

  double mTimeStamp;
  int N = 20;
  std::vector<cv::KeyPoint> mvKeys, mvKeysUn;
  std::vector<float> mvuRight = std::vector<float>(20, -1.0F);
  std::vector<float> mvDepth = std::vector<float>(20, 3.0F);
  cv::Mat mDescriptors;
  std::vector<void*> mvpMapPoints = std::vector<void*>(20, nullptr);
  std::vector<bool> mvbOutlier = std::vector<bool>(20, false);
  std::array<std::array<std::vector<std::size_t>, 1>, 2> mGrid;
};
