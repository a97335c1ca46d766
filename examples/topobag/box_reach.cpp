// SPDX-License-Identifier: MIT
#include "box_reach.hpp"

namespace program {

void BoxReach::add(const topobag::BoundingBox& box) {
  if (width_ <= 0.0 || height_ <= 0.0) return;
  ++boxes_;
  if (is_beyond(box)) ++beyond_;
  const auto swapped = topobag::box_around(box.center(), box.height(), box.width());
  if (is_beyond(swapped)) ++beyond_swapped_;
}

bool BoxReach::is_beyond(const topobag::BoundingBox& box) const {
  const double border = 0.1;  // of the image's size
  return box.x1 < -border * width_ || box.y1 < -border * height_ ||
         box.x2 > (1.0 + border) * width_ || box.y2 > (1.0 + border) * height_;
}

std::string BoxReach::complaint(const std::string& form) const {
  const std::size_t few = 5, share = 20;  // one in so many
  if (beyond_ < few || share * beyond_ < boxes_) return "";
  const std::string found = std::to_string(beyond_) + " of " + std::to_string(boxes_) +
                            " boxes reach far beyond the image; ";
  const bool swapped = 10 * beyond_swapped_ < beyond_;
  return found + form + (swapped ? ": are width and height the other way round?" : "");
}

}  // namespace program
