// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detection.hpp>

namespace program {

/// The boxes that another detector found in the images of a sequence.
struct ImageBoxes {
  /// Parallel to the images; boxes in px from the centre of the first pixel.
  std::vector<std::vector<topobag::Detection>> of_image;
  std::size_t without_boxes = 0;  ///< images that the files say nothing of
  std::size_t other_images = 0;   ///< images with boxes that the sequence does not have
  std::size_t empty = 0;          ///< boxes without width or height (below 0.001 px), left out
  std::size_t unscored = 0;       ///< boxes that say no score, which is then 1
};

/// How boxes are read.
struct BoxReading {
  std::vector<topobag::ClassId> classes;  ///< the class behind each number of a YOLO file
  topobag::ClassCatalog catalog = topobag::ClassCatalog::coco80();
  int width = 0;   ///< of the images, px; 0 = unknown, which YOLO files do not do with
  int height = 0;  ///< px
};

/// Reads what other detectors wrote of the images of a sequence.
///
/// A folder holds one YOLO text file an image, `<image>.txt`, with lines `class cx cy w h [score]`,
/// the box as shares of the image and the class as a position in `classes`. A file is COCO's JSON:
/// a list of results (image_id, category_id, bbox, score) with the catalog's numbers of categories,
/// COCO's own (1 to 90) for its classes, or a data set (images, categories, annotations) with
/// categories by name. An image goes by its file's name (see `ImageNames`) or, where there is none,
/// by its id. Scores lie in [0, 1].
/// @param images  paths of the sequence's images
/// Throws topobag::Error with the file and the line or entry, also where it speaks of none of the
/// images.
ImageBoxes read_boxes(const std::string& path, const std::vector<std::string>& images,
                      const BoxReading& reading);

}  // namespace program
