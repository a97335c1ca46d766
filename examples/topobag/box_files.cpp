// SPDX-License-Identifier: MIT
#include "box_files.hpp"

#include <exception>
#include <filesystem>
#include <sstream>

#include "csv_reader.hpp"
#include "input_error.hpp"
#include "json_output.hpp"

namespace program {
namespace {

using topobag::Detection;

const std::string line_format = "a line is: class cx cy w h [score]";
const std::string score_range = "the score has to lie in [0, 1]";

bool is_share(double score) { return score >= 0.0 && score <= 1.0; }

std::string stem(const std::string& file) { return std::filesystem::path(file).stem().string(); }

std::vector<Detection> read_yolo_text(const std::string& path,
                                      const std::vector<topobag::ClassId>& classes, int width,
                                      int height) {
  std::vector<Detection> detections;
  std::istringstream lines(read_file(path));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream words(line);
    std::size_t label = 0;
    double cx = 0.0, cy = 0.0, w = 0.0, h = 0.0, score = 1.0;
    if (!(words >> label >> cx >> cy >> w >> h)) {
      throw InputError(path, number, line_format);
    }
    if (!(words >> std::ws).eof() && !(words >> score)) {
      throw InputError(path, number, "the score is not a number");
    }
    if (!(words >> std::ws).eof()) throw InputError(path, number, line_format);
    if (!is_share(score)) throw InputError(path, number, score_range);
    if (label >= classes.size()) {
      throw InputError(path, number,
                       "there is no class " + std::to_string(label) + "; give --names");
    }
    detections.push_back(
        {topobag::box_around({cx * width - 0.5, cy * height - 0.5}, w * width, h * height),
         classes[label], score});
  }
  return detections;
}

/// The names behind COCO's numbers of images and categories, where the file has them.
std::map<std::string, std::string> names_by_id(const nlohmann::json& file, const char* list,
                                               const char* name) {
  std::map<std::string, std::string> names;
  if (!file.is_object() || !file.contains(list)) return names;
  for (const nlohmann::json& entry : file.at(list)) {
    names[entry.at("id").dump()] = entry.at(name).get<std::string>();
  }
  return names;
}

/// The class of a number in COCO's own counting, which runs from 1 to 90 and leaves out ten.
topobag::ClassId coco_class(const nlohmann::json& category) {
  // As a double first: a number in JSON may be more than an int holds.
  const double given = category.is_number() ? category.get<double>() : 0.0;
  const int number = given >= 1.0 && given <= 90.0 ? static_cast<int>(given) : 0;
  int position = number - 1;
  for (const int absent : {12, 26, 29, 30, 45, 66, 68, 69, 71, 83}) {
    if (number == absent) position = -1;
    if (number > absent) --position;
  }
  if (position < 0 || given != number) {
    throw InputError("category " + category.dump() + " is none of COCO's");
  }
  return topobag::ClassId{position};
}

BoxesByImage read_coco(const std::string& path, const topobag::ClassCatalog& catalog) {
  BoxesByImage boxes;
  std::size_t number = 0;
  try {
    const nlohmann::json file = nlohmann::json::parse(read_file(path));
    const auto images = names_by_id(file, "images", "file_name");
    const auto categories = names_by_id(file, "categories", "name");
    for (const nlohmann::json& entry : file.is_array() ? file : file.at("annotations")) {
      ++number;
      const nlohmann::json& image = entry.at("image_id");
      const auto named = images.find(image.dump());
      const std::string key = named != images.end() ? named->second
                              : image.is_string()   ? image.get<std::string>()
                                                    : image.dump();
      const nlohmann::json& category = entry.at("category_id");
      const auto called = categories.find(category.dump());
      const topobag::ClassId label =
          called != categories.end() ? catalog.at(called->second) : coco_class(category);
      const auto& box = entry.at("bbox");
      const double x = box.at(0), y = box.at(1), w = box.at(2), h = box.at(3);
      const double score = entry.value("score", 1.0);
      if (!is_share(score)) throw InputError(score_range);
      boxes[stem(key)].push_back({{x - 0.5, y - 0.5, x + w - 0.5, y + h - 0.5}, label, score});
    }
  } catch (const std::exception& error) {
    throw InputError(path + ", entry " + std::to_string(number) + ": " + error.what());
  }
  return boxes;
}

}  // namespace

BoxesByImage read_boxes(const std::string& path, const std::vector<topobag::ClassId>& classes,
                        const topobag::ClassCatalog& catalog, int width, int height) {
  if (!std::filesystem::is_directory(path)) return read_coco(path, catalog);
  BoxesByImage boxes;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    if (entry.path().extension() != ".txt") continue;
    boxes[entry.path().stem().string()] =
        read_yolo_text(entry.path().string(), classes, width, height);
  }
  if (boxes.empty()) throw InputError(path, "there is no .txt file in the folder");
  return boxes;
}

}  // namespace program
