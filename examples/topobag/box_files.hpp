// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include <topobag/types/class_catalog.hpp>
#include <topobag/types/detection.hpp>

namespace program {

/// The detections of the images by name without folder and suffix, boxes in px from the centre of
/// the first pixel.
using BoxesByImage = std::map<std::string, std::vector<topobag::Detection>>;

/// Reads what other detectors wrote.
///
/// A folder holds one YOLO text file an image, `<image>.txt`, with lines `class cx cy w h [score]`,
/// the box as shares of the image and the class as a position in `classes`. A file is COCO's JSON:
/// a list of results (image_id, category_id, bbox, score) with COCO's own numbers of categories, or
/// a data set (images, categories, annotations) with categories by name. An image goes by its
/// file's name or, where there is none, by its id. Scores lie in [0, 1].
/// @param classes       the class behind each number of a YOLO file
/// @param catalog       COCO's 80 classes
/// @param width,height  of the images, px; for YOLO files
/// Throws InputError with the file and the line or entry.
BoxesByImage read_boxes(const std::string& path, const std::vector<topobag::ClassId>& classes,
                        const topobag::ClassCatalog& catalog, int width, int height);

}  // namespace program
