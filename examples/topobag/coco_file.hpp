// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detection.hpp>

namespace program {

/// An image of a COCO file and its boxes.
struct CocoImage {
  std::string name;                       ///< its file's, or its id where the file lists no images
  int width = 0;                          ///< px; 0 = not stated
  int height = 0;                         ///< px
  std::vector<topobag::Detection> boxes;  ///< px from the centre of the first pixel
  bool listed = false;                    ///< among `images`
};

/// Reads a COCO file, see `read_boxes`; a box may be without width or height. Throws InputError
/// with the file and the entry.
std::vector<CocoImage> read_coco(const std::string& path, const topobag::ClassCatalog& catalog);

}  // namespace program
