// SPDX-License-Identifier: MIT
#pragma once

/// All that needs OpenCV: link `topobag::opencv`.
#include <topobag/adaptors/opencv/color_image.hpp>
#include <topobag/adaptors/opencv/depth_image.hpp>
#include <topobag/adaptors/opencv/letterbox.hpp>
#include <topobag/adaptors/opencv/undistort.hpp>
#include <topobag/adaptors/opencv/yolo_detector.hpp>
