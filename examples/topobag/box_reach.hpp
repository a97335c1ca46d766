// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <topobag/types/detection.hpp>

namespace program {

/// How many boxes reach so far beyond their image as no detector's do.
class BoxReach {
 public:
  /// @param width,height  of the image, px; 0 = not known, and nothing is counted
  BoxReach(int width, int height) : width_(width), height_(height) {}

  void add(const topobag::BoundingBox& box);

  /// What is wrong with the boxes, in words, where too many do; empty where they do not.
  /// @param form  what a box is in their file
  std::string complaint(const std::string& form) const;

 private:
  bool is_beyond(const topobag::BoundingBox& box) const;

  double width_, height_;
  std::size_t boxes_ = 0;
  std::size_t beyond_ = 0;
  std::size_t beyond_swapped_ = 0;  ///< were width and height the other way round
};

}  // namespace program
