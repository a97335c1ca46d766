// SPDX-License-Identifier: MIT
#include "object_map_options.hpp"

#include <string>

#include "map_relation.hpp"
#include "number_check.hpp"

namespace program {

void add_object_map_options(CLI::App& command, ObjectMapOptions& objects, ObjectClasses& classes) {
  command.add_option_function<std::string>(
      "--map-words", [&classes](const std::string& path) { add_map_words(path, classes); },
      "Of a map of objects: its classes, one a line, where they are not the queries'");
  command.add_option_function<std::string>(
      "--map-relation",
      [&](const std::string& path) {
        const MapRelation relation = read_relation(path, classes.catalog);
        objects.relation = path;
        objects.learnt_of = relation.map;
        objects.scale = relation.scale;
        objects.deviation = relation.deviation;
        classes.confusion = confusion_of(relation, classes);
      },
      "Of a map of objects: its scale, deviation and classes as `relate` learnt them");
  command
      .add_option("--object-scale", objects.scale,
                  "Of a map of objects: by which its lengths are too long")
      ->check(number_above_zero())
      ->default_str("1");
  command
      .add_option("--object-deviation", objects.deviation,
                  "Of a map of objects: standard deviation of its positions, m")
      ->check(number_above_zero())
      ->default_str("0.05");
}

}  // namespace program
