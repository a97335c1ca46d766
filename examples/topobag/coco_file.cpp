// SPDX-License-Identifier: MIT
#include "coco_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <map>

#include <topobag/types/catalog_fingerprint.hpp>

#include "csv_reader.hpp"
#include "input_error.hpp"
#include "json_output.hpp"

namespace program {
namespace {

/// An id as one text, whether a tool wrote it as 7, 7.0 or "7".
std::string id_text(const Json& id) {
  if (id.is_string()) return id.get<std::string>();
  if (!id.is_number()) throw InputError("an id is a number or a text, not " + json_text(id));
  const auto whole = topobag::parse_whole(json_text(id));
  return whole ? std::to_string(*whole) : json_text(id);
}

/// The class of a number in COCO's own counting, which runs from 1 to 90 and leaves out ten.
topobag::ClassId coco_class(const Json& category) {
  const double given = category.is_number() ? category.get<double>() : 0.0;
  const int number = given >= 1.0 && given <= 90.0 ? static_cast<int>(given) : 0;
  int position = number - 1;
  for (const int absent : {12, 26, 29, 30, 45, 66, 68, 69, 71, 83}) {
    if (number == absent) position = -1;
    if (number > absent) --position;
  }
  if (position < 0 || given != number) {
    throw InputError("category " + json_text(category) +
                     " is none of COCO's, which are numbers from 1 to 90 without ten; give "
                     "--classes for another list, from 0");
  }
  return topobag::ClassId{position};
}

/// The class of a category's number, where the file does not name it: COCO's own numbers for COCO's
/// classes, else the catalog's.
topobag::ClassId numbered_class(const Json& category, const topobag::ClassCatalog& catalog) {
  if (topobag::fingerprint(catalog) == topobag::fingerprint(topobag::ClassCatalog::coco80())) {
    return coco_class(category);
  }
  const auto number = topobag::parse_whole(json_text(category));
  const std::int64_t none = -1, largest = std::numeric_limits<std::int32_t>::max();
  const topobag::ClassId label{
      static_cast<std::int32_t>(std::clamp(number.value_or(none), none, largest))};
  if (!catalog.contains(label)) {
    throw InputError("category " + json_text(category) + " is the number of no class, from 0 to " +
                     std::to_string(catalog.size() - 1) +
                     "; number them so, or give a data set that lists its categories by name");
  }
  return label;
}

/// Calls `read(id, entry)` for what a data set lists by id. An id may be there again only with the
/// same `name`.
template <typename Read>
void read_list(const Json& file, const char* list, const char* name, const Read& read) {
  if (!file.is_object() || !file.contains(list)) return;
  std::map<std::string, std::string> names;
  for (const Json& entry : file.at(list)) {
    const std::string id = id_text(entry.at("id"));
    const auto [known, is_new] = names.emplace(id, entry.at(name).get<std::string>());
    if (is_new) {
      read(id, entry);
    } else if (known->second != entry.at(name)) {
      throw InputError(std::string(list) + " gives id " + id + " to '" + known->second +
                       "' and to '" + entry.at(name).get<std::string>() + "'");
    }
  }
}

/// The name that the file gives to a category.
const std::string& named_category(const Json& category,
                                  const std::map<std::string, std::string>& categories) {
  const auto called = category.is_null() ? categories.end() : categories.find(id_text(category));
  if (called != categories.end()) return called->second;
  throw InputError("category " + json_text(category) + " is not among the file's categories");
}

topobag::Detection detection_of(const Json& entry, topobag::ClassId label) {
  const Json& box = entry.at("bbox");
  const bool numbers = box.is_array() && box.size() == 4 &&
                       std::all_of(box.begin(), box.end(), [](auto& x) { return x.is_number(); });
  if (!numbers) throw InputError("bbox has to be four numbers: x, y, width, height");
  const double x = box[0], y = box[1], w = box[2], h = box[3];
  if (w < 0.0 || h < 0.0) throw InputError("bbox has a negative width or height");
  const Json scored = entry.value("score", Json(1.0));
  if (!scored.is_number()) throw InputError("the score has to be a number in [0, 1]");
  const double score = scored;
  if (!(score >= 0.0 && score <= 1.0))
    throw InputError("the score has to lie in [0, 1], not " + json_text(scored));
  return {{x - 0.5, y - 0.5, x + w - 0.5, y + h - 0.5}, label, score};
}

/// Throws where no box reaches beyond the first pixel.
void require_pixels(const std::vector<CocoImage>& images) {
  double furthest = 0.0;
  for (const CocoImage& image : images) {
    for (const topobag::Detection& box : image.boxes) {
      furthest = std::max({furthest, box.box.x2, box.box.y2});
    }
  }
  if (furthest > 0.0 && furthest <= 0.5) {
    throw InputError("every bbox lies in [0, 1], as shares of the image do; COCO's are in px");
  }
}

}  // namespace

std::vector<CocoImage> read_coco(const std::string& path, const topobag::ClassCatalog& catalog) {
  const std::string text = read_file(path);
  if (text.find_first_not_of(" \t\r\n") == text.npos) throw InputError(path, "the file is empty");
  const std::string_view beginning = topobag::trimmed(std::string_view(text).substr(0, 1000));
  const bool utf_16 = beginning.substr(0, 2) == "\xFF\xFE" || beginning.substr(0, 2) == "\xFE\xFF";
  const bool json =
      beginning.empty() || std::string_view("{[\xEF").find(beginning.front()) != text.npos;
  if (!json && !utf_16) {
    throw InputError(path, "it is neither a folder of YOLO text files nor COCO's JSON");
  }
  std::vector<CocoImage> images;
  std::size_t number = 0;
  try {
    const Json file = parsed_json(text);
    if (!file.is_array() && !file.contains("annotations")) {
      throw InputError("it is neither COCO's list of results nor a data set with 'annotations'");
    }
    std::map<std::string, std::size_t> image_of;
    read_list(file, "images", "file_name", [&](const std::string& id, const Json& entry) {
      image_of[id] = images.size();
      images.push_back(
          {entry.at("file_name"), entry.value("width", 0), entry.value("height", 0), {}, true});
    });
    std::map<std::string, std::string> categories;
    read_list(file, "categories", "name", [&](const std::string& id, const Json& entry) {
      categories[id] = entry.at("name").get<std::string>();
    });
    const bool lists_images = !images.empty();
    for (const Json& entry : file.is_array() ? file : file.at("annotations")) {
      ++number;
      const std::string id = id_text(entry.at("image_id"));
      const auto [image, is_new] = image_of.emplace(id, images.size());
      // An id that a data set does not list is the name of no image.
      if (is_new)
        images.push_back({lists_images ? "unlisted image_id " + id : id, 0, 0, {}, false});
      const Json& category = entry.at("category_id");
      const topobag::ClassId label = categories.empty()
                                         ? numbered_class(category, catalog)
                                         : catalog.at(named_category(category, categories));
      images[image->second].boxes.push_back(detection_of(entry, label));
    }
    number = 0;
    require_pixels(images);
  } catch (const std::exception& error) {
    throw InputError(path + (number > 0 ? ", entry " + std::to_string(number) : "") + ": " +
                     json_complaint(error));
  }
  return images;
}

}  // namespace program
