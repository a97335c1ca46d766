// SPDX-License-Identifier: MIT
#include "box_files.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "box_reach.hpp"
#include "coco_file.hpp"
#include "csv_reader.hpp"
#include "image_names.hpp"
#include "input_error.hpp"

namespace program {
namespace {

using topobag::Detection;

/// The share of the image that a field is: a number in [0, 1].
double share_of(const topobag::TextLines& lines, std::string_view field, const char* what) {
  const double share = lines.number(field);
  const double rounding = 1e-3;
  if (share >= -rounding && share <= 1.0 + rounding) return std::clamp(share, 0.0, 1.0);
  throw lines.error(std::string(what) + " " + std::string(field) +
                    " is no share of the image in [0, 1]" +
                    (share > 1.0 ? "; divide px by the image's size" : ""));
}

/// What a line of so many fields is, which is none of a box.
std::string fields_complaint(std::size_t fields) {
  const std::string found = "here are " + std::to_string(fields) + " fields";
  const std::string wanted = "a line is: class cx cy w h [score]";
  if (fields == 7) return found + ", a track's id behind the score, or three corners; " + wanted;
  if (fields < 7 || fields % 2 == 0) return found + "; " + wanted;
  return found + ", as of a polygon of " + std::to_string(fields / 2) +
         " corners, and boxes are needed; " + wanted;
}

/// @param unscored  counts the boxes that say no score
std::vector<Detection> read_yolo_text(const std::string& path, const BoxReading& reading,
                                      std::size_t& unscored) {
  std::vector<Detection> detections;
  std::istringstream stream(read_file(path));
  topobag::TextLines lines(stream, path);
  std::vector<std::string_view> fields;
  for (std::string_view line; lines.next(line);) {
    topobag::TextLines::split(line, fields);
    if (fields.size() != 5 && fields.size() != 6)
      throw lines.error(fields_complaint(fields.size()));
    const auto label = topobag::parse_whole(fields[0]);
    if (!label)
      throw lines.error("the class '" + std::string(fields[0]) +
                        "' is no whole number; a line is: class cx cy w h [score], by the class' "
                        "number, with decimal points");
    if (*label < 0 || static_cast<std::size_t>(*label) >= reading.classes.size()) {
      throw lines.error("there is no class " + std::to_string(*label) + " among 0 to " +
                        std::to_string(reading.classes.size() - 1) +
                        "; give the detector's own classes by --names");
    }
    const double cx = share_of(lines, fields[1], "cx"), cy = share_of(lines, fields[2], "cy");
    const double w = share_of(lines, fields[3], "w"), h = share_of(lines, fields[4], "h");
    const double score = fields.size() == 6 ? lines.number(fields[5]) : 1.0;
    if (fields.size() == 5) ++unscored;
    if (!(score >= 0.0 && score <= 1.0)) {
      const bool whole = topobag::parse_whole(fields[5]).has_value();
      throw lines.error("the score has to lie in [0, 1], not " + std::string(fields[5]) +
                        (whole ? "; is " + std::string(fields[5]) + " the id of a track?" : ""));
    }
    detections.push_back({topobag::box_around({cx * reading.width - 0.5, cy * reading.height - 0.5},
                                              w * reading.width, h * reading.height),
                          reading.classes[static_cast<std::size_t>(*label)], score});
  }
  return detections;
}

/// Throws where a file states another size of an image than the camera has.
void require_size(const std::string& path, const CocoImage& image, const BoxReading& reading) {
  const bool stated = image.width > 0 && image.height > 0 && reading.width > 0;
  if (!stated || (image.width == reading.width && image.height == reading.height)) return;
  throw InputError(path, "image '" + image.name + "' is " + std::to_string(image.width) + " x " +
                             std::to_string(image.height) + " px, the camera's " +
                             std::to_string(reading.width) + " x " +
                             std::to_string(reading.height));
}

/// Throws where a box reaches so far beyond the camera's image that it cannot be of it.
void require_reach(const std::string& path, const CocoImage& image, const BoxReading& reading) {
  if (reading.width == 0) return;
  const double most = 1.5;  // of the size: a box around a point of the border that is as wide
  for (const Detection& detection : image.boxes) {
    const topobag::BoundingBox& box = detection.box;
    if (box.x2 <= most * reading.width && box.y2 <= most * reading.height) continue;
    std::ostringstream why;
    why << "a bbox of image '" << image.name << "' ends at " << box.x2 + 0.5 << ", " << box.y2 + 0.5
        << " px, the camera's image at " << reading.width << ", " << reading.height
        << "; a bbox is x, y, width, height";
    throw InputError(path, why.str());
  }
}

/// The names of the label files in a folder, sorted.
std::vector<std::string> label_files(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".txt") names.push_back(entry.path().filename().string());
  }
  if (names.empty()) throw InputError(folder, "there is no .txt file in the folder");
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

ImageBoxes read_boxes(const std::string& path, const std::vector<std::string>& images,
                      const BoxReading& reading) {
  std::vector<CocoImage> coco;
  std::vector<std::string> names;
  const bool yolo = std::filesystem::is_directory(path);
  if (yolo) {
    names = label_files(path);
  } else {
    coco = read_coco(path, reading.catalog);
    for (const CocoImage& image : coco) names.push_back(image.name);
  }
  if (names.empty()) throw InputError(path, "it holds neither an image nor a box");
  const std::vector<std::size_t> found = ImageNames(images).find(names, path);
  ImageBoxes boxes;
  BoxReach reach(reading.width, reading.height);
  std::vector<bool> used(names.size(), false);
  for (const std::size_t name : found) {
    std::vector<Detection>& of_image = boxes.of_image.emplace_back();
    if (name == ImageNames::none) {
      ++boxes.without_boxes;
      continue;
    }
    used[name] = true;
    if (!yolo) {
      require_size(path, coco[name], reading);
      require_reach(path, coco[name], reading);
    }
    of_image = yolo ? read_yolo_text((std::filesystem::path(path) / names[name]).string(), reading,
                                     boxes.unscored)
                    : coco[name].boxes;
    const auto empty = [](const Detection& detection) {
      const double rounding = 1e-3;  // px; of files that write few digits
      const topobag::BoundingBox& box = detection.box;
      return !box.is_valid() || box.width() < rounding || box.height() < rounding;
    };
    const auto kept = std::remove_if(of_image.begin(), of_image.end(), empty);
    boxes.empty += static_cast<std::size_t>(of_image.end() - kept);
    of_image.erase(kept, of_image.end());
    for (const Detection& detection : of_image) reach.add(detection.box);
  }
  const std::string beyond =
      reach.complaint(yolo ? "a line is: class cx cy w h [score], by a box's centre and size"
                           : "a bbox is x, y, width, height, from its upper left corner");
  if (!beyond.empty()) throw InputError(path, beyond);
  for (std::size_t name = 0; name < names.size(); ++name) {
    if (!used[name] && (yolo || !coco[name].boxes.empty())) ++boxes.other_images;
  }
  if (boxes.without_boxes < images.size()) return boxes;
  throw InputError(path, "it speaks of none of the sequence's " + std::to_string(images.size()) +
                             " images, but of " + std::to_string(names.size()) +
                             " others, such as '" + names.front() + "'; the first is '" +
                             std::filesystem::path(images.front()).filename().string() + '\'');
}

}  // namespace program
