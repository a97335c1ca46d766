// SPDX-License-Identifier: MIT
#include "class_list.hpp"

#include <cstddef>
#include <sstream>
#include <string_view>

#include "csv_reader.hpp"
#include "input_error.hpp"

namespace program {

std::vector<topobag::ClassId> read_class_list(const std::string& path,
                                              const topobag::ClassCatalog& catalog) {
  std::vector<topobag::ClassId> classes;
  std::istringstream stream(read_file(path));
  topobag::TextLines lines(stream, path);
  std::size_t before = 0;
  for (std::string_view line; lines.next(line); before = lines.number()) {
    if (!classes.empty() && lines.number() != before + 1) {
      throw lines.error("a blank or comment line above hides which number this class has");
    }
    lines.located([&] { classes.push_back(catalog.at(std::string(line))); });
  }
  if (classes.empty()) throw InputError(path, "there is no class in the file");
  return classes;
}

}  // namespace program
