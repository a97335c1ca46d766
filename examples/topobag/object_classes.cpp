// SPDX-License-Identifier: MIT
#include "object_classes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string_view>
#include <vector>

#include <topobag/types/catalog_fingerprint.hpp>

#include "csv_reader.hpp"
#include "input_error.hpp"

namespace program {
namespace {

/// The parts of a text between separators, without the blanks around them; at least one.
std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.emplace_back(topobag::trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

/// Calls `read(lines, fields)` for the four fields of each line; those left out are empty.
template <typename Read>
void read_class_lines(const std::string& path, const std::string& text, const Read& read) {
  std::istringstream stream(text);
  topobag::TextLines lines(stream, path);
  for (std::string_view line; lines.next(line);) {
    std::vector<std::string> fields = parts_of(line, ',');
    if (fields.size() > 4) {
      throw lines.error("a line is: name[, dynamics[, look-alikes[, typical size]]]");
    }
    fields.resize(4);
    read(lines, fields);
  }
}

topobag::Dynamics dynamics_of(const topobag::TextLines& lines, const std::string& text) {
  if (text.empty() || text == "low") return topobag::Dynamics::low;
  if (text == "medium") return topobag::Dynamics::medium;
  if (text == "high") return topobag::Dynamics::high;
  throw lines.error("the dynamics '" + text + "' are none of low, medium and high");
}

/// Throws where a name is certainly none: a number, or what another format puts beside a name.
void require_name(const topobag::TextLines& lines, const std::string& name) {
  const std::size_t digits = name.find_first_not_of("0123456789 ");
  const std::string advice = ": a line is name[, dynamics[, look-alikes[, typical size]]]";
  if (digits != name.npos && digits > 0 && name[digits] == ':') {
    throw lines.error("'" + name + "' is a number and a name" + advice +
                      ", and a class has the number of its line, from 0");
  }
  for (const char separator : {';', '\t'}) {
    if (name.find(separator) == name.npos) continue;
    throw lines.error("'" + name + "' holds a " + (separator == ';' ? "semicolon" : "tab") +
                      advice + ", separated by commas");
  }
  const bool letter = std::any_of(name.begin(), name.end(), [](unsigned char c) {
    return c >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  });
  if (name.empty() || letter) return;  // a catalog refuses the empty name itself
  throw lines.error("'" + name + "' has no letter, which a class's name has" + advice);
}

void add_class(const topobag::TextLines& lines, const std::vector<std::string>& fields,
               topobag::ClassCatalog& catalog) {
  const std::string& name = fields[0];
  require_name(lines, name);
  if (const auto known = catalog.find(name)) {
    throw lines.error("'" + name + "' is class " + std::to_string(topobag::value(*known)) +
                      " already; give each class a name of its own");
  }
  const topobag::ClassId id{static_cast<int>(catalog.size())};
  const topobag::Dynamics dynamics = dynamics_of(lines, fields[1]);
  lines.located([&] { catalog.add(id, name, dynamics); });
}

std::array<double, 2> size_of(const topobag::TextLines& lines, const std::string& text) {
  const std::vector<std::string> sides = parts_of(text, 'x');
  std::array<double, 2> size{};
  bool good = sides.size() == 2;
  for (std::size_t i = 0; good && i < 2; ++i) {
    size[i] = parse_number(sides[i]).value_or(0.0);
    good = size[i] > 0.0;
  }
  if (!good) {
    throw lines.error("the typical size '" + text + "' is no width x height in metres");
  }
  const double largest = 20.0;  // m; a lorry with its trailer is 18.75 long
  if (size[0] > largest || size[1] > largest) {
    throw lines.error("the typical size '" + text +
                      "' is larger than 20 m: sizes are in metres, 50 cm is 0.5");
  }
  return size;
}

}  // namespace

ObjectClasses read_object_classes(const std::string& path) {
  const std::string text = read_file(path);
  ObjectClasses classes;
  classes.file = path;
  classes.catalog = {};
  classes.lookalikes = {};
  read_class_lines(path, text, [&](const topobag::TextLines& lines, const auto& fields) {
    add_class(lines, fields, classes.catalog);
  });
  if (classes.catalog.size() == 0) throw InputError(path, "there is no class in the file");
  read_class_lines(path, text, [&](const topobag::TextLines& lines, const auto& fields) {
    const topobag::ClassId id = classes.catalog.at(fields[0]);
    if (!fields[3].empty()) classes.sizes[id] = size_of(lines, fields[3]);
    if (fields[2].empty()) return;
    for (const std::string& other : parts_of(fields[2], '|')) {
      lines.located([&] { classes.lookalikes.join(id, classes.catalog.at(other)); });
    }
  });
  return classes;
}

void add_map_words(const std::string& path, ObjectClasses& classes) {
  const std::string text = read_file(path);
  std::istringstream stream(text);
  topobag::TextLines lines(stream, path);
  const int first = static_cast<int>(classes.catalog.size());
  int next = first;
  for (std::string_view line; lines.next(line); ++next) {
    if (next - first + 1 != static_cast<int>(lines.number())) {
      throw lines.error("a blank or comment line above hides which number this class has");
    }
    lines.located([&] {
      classes.catalog.add(topobag::ClassId{next}, std::string(line) + " (map)",
                          topobag::Dynamics::low);
    });
  }
  if (next == first) throw InputError(path, "there is no class in the file");
  classes.first_word = first;
}

topobag::DescribedCatalog described(const ObjectClasses& classes) {
  topobag::DescribedCatalog catalog(classes.catalog);
  catalog.lookalikes = classes.lookalikes;
  catalog.sizes = classes.sizes;
  catalog.source = classes.file.empty() ? "COCO's classes" : classes.file;
  return catalog;
}

bool may_adopt(const ObjectClasses& classes) {
  return classes.file.empty() && !classes.first_word && !classes.confusion;
}

ObjectClasses adopted(ObjectClasses given, const topobag::DescribedCatalog& kept,
                      const std::string& map) {
  if (topobag::fingerprint(kept.catalog) == topobag::fingerprint(given.catalog)) {
    if (!topobag::difference(kept, described(given))) return given;
    for (const topobag::ClassId id : kept.catalog.ids()) {
      given.catalog.set_dynamics(id, kept.catalog.dynamics(id));
    }
  } else {
    given.catalog = kept.catalog;
    given.lookalikes = topobag::lookalike_classes(kept.catalog);
    given.sizes = {};
  }
  given.file = map;
  if (kept.lookalikes) given.lookalikes = *kept.lookalikes;
  if (kept.sizes) given.sizes = *kept.sizes;
  return given;
}

void add_classes_option(CLI::App& command, ObjectClasses& classes) {
  command.add_option_function<std::string>(
      "--classes", [&classes](const std::string& path) { classes = read_object_classes(path); },
      "File of your detector's classes, one a line: name, dynamics (low, medium or high), "
      "look-alikes (between |), typical size (width x height, m); a map goes with the classes that "
      "it was made with [those that a map keeps, else COCO's 80]");
}

topobag::RecognitionOptions recognition_options_for(const ObjectClasses& classes) {
  topobag::RecognitionOptions options = topobag::recognition_options(classes.catalog);
  options.matching.consistency.classes = classes.lookalikes;
  if (classes.confusion) {
    // A class of the map is offered to what it is rather than not: to one class of the queries.
    options.matching.chance.confusion = classes.confusion;
    options.matching.consistency.classes = classes.confusion->groups(0.5, classes.lookalikes);
  }
  return options;
}

}  // namespace program
