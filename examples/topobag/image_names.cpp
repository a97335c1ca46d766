// SPDX-License-Identifier: MIT
#include "image_names.hpp"

#include <algorithm>
#include <filesystem>

#include "input_error.hpp"

namespace program {
namespace {

using Parts = std::vector<std::string>;

/// The parts of a path, the last one, without its suffix, first. Digits are no suffix, but those of
/// a time stamp.
Parts parts_of(std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  const std::string suffix = normal.extension().string();
  const bool time = suffix.find_first_not_of(".0123456789") == std::string::npos;
  Parts parts{(time ? normal.filename() : normal.stem()).string()};
  for (const auto& part : normal.parent_path()) parts.insert(parts.begin() + 1, part.string());
  return parts;
}

/// How many parts two paths have in common at their ends.
std::size_t common_parts(const Parts& a, const Parts& b) {
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
  return static_cast<std::size_t>(end - a.begin());
}

std::string folder_and_name(const Parts& parts) {
  std::string name = parts.front();
  for (std::size_t i = 1; i < std::min<std::size_t>(parts.size(), 2); ++i) {
    name = parts[i] + '/' + name;
  }
  return '\'' + name + '\'';
}

}  // namespace

ImageNames::ImageNames(const std::vector<std::string>& images) {
  for (const std::string& image : images) {
    images_.push_back(parts_of(std::filesystem::absolute(image).string()));
  }
}

std::vector<std::size_t> ImageNames::find(const std::vector<std::string>& names,
                                          const std::string& file) const {
  std::vector<Parts> parts;
  std::map<std::string, std::vector<std::size_t>> of_stem;
  for (const std::string& name : names) {
    parts.push_back(parts_of(name));
    of_stem[parts.back().front()].push_back(parts.size() - 1);
  }
  std::vector<std::size_t> found;
  std::map<std::size_t, std::size_t> image_of;
  for (std::size_t i = 0; i < images_.size(); ++i) {
    std::vector<std::size_t> alike = of_stem[images_[i].front()];
    found.push_back(none);
    if (alike.empty()) continue;
    const auto common = [&](std::size_t name) { return common_parts(images_[i], parts[name]); };
    std::stable_sort(alike.begin(), alike.end(),
                     [&](std::size_t a, std::size_t b) { return common(a) > common(b); });
    if (alike.size() > 1 && common(alike[0]) == common(alike[1])) {
      throw InputError(file, folder_and_name(parts[alike[0]]) + " and " +
                                 folder_and_name(parts[alike[1]]) + " may both be the image " +
                                 folder_and_name(images_[i]) +
                                 "; give the boxes of one camera, or folders of the same name");
    }
    found.back() = alike[0];
    const auto [other, is_new] = image_of.emplace(alike[0], i);
    if (!is_new && images_[other->second] != images_[i]) {
      throw InputError(file, folder_and_name(parts[alike[0]]) + " may be the image " +
                                 folder_and_name(images_[other->second]) + " or " +
                                 folder_and_name(images_[i]) + "; give its folder with it");
    }
  }
  return found;
}

}  // namespace program
