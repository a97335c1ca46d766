// SPDX-License-Identifier: MIT
#include "score_names.hpp"

#include <cstddef>
#include <filesystem>
#include <map>

#include "input_error.hpp"

namespace program {

std::vector<std::string> score_names(const std::vector<std::string>& paths) {
  std::map<std::string, std::size_t> files, names;
  for (const std::string& path : paths) {
    if (++files[std::filesystem::weakly_canonical(std::filesystem::absolute(path)).string()] > 1) {
      throw InputError("--scores " + path, "it is given twice; leave one out");
    }
    ++names[std::filesystem::path(path).filename().string()];
  }
  std::vector<std::string> called;
  for (const std::string& path : paths) {
    const std::string name = std::filesystem::path(path).filename().string();
    called.push_back(names[name] > 1 ? path : name);
  }
  return called;
}

}  // namespace program
