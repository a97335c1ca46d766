// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <topobag/bag/described_catalog.hpp>
#include <topobag/matching/class_confusion.hpp>
#include <topobag/matching/class_groups.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/types/class_catalog.hpp>

#include "typical_sizes.hpp"

namespace program {

/// What the class numbers of a detector mean, and which classes it takes for one another: COCO's
/// 80, or the user's own.
struct ObjectClasses {
  topobag::ClassCatalog catalog = topobag::ClassCatalog::coco80();
  topobag::ClassGroups lookalikes = topobag::lookalike_classes(catalog);
  /// What a map's class is called in the queries, where that was learnt.
  std::optional<topobag::ClassConfusion> confusion{};
  /// The number of the first class that is a word of the map alone; none without.
  std::optional<int> first_word{};
  TypicalSizes sizes{};  ///< of those for which the file says so
  std::string file{};    ///< that says all this; empty: none, and a map's own classes come first
};

/// Reads classes of the user's own, one a line:
///
///     # name, dynamics, look-alikes, typical size
///     forklift, high
///     pallet, low, pallet with load | box, 1.2 x 0.15
///     pallet with load
///     box, medium
///
/// A class has the number of its line among these, from 0. Dynamics are low (as where they are left
/// out), medium or high; look-alikes are names of the file's classes between bars, said by either
/// of the two; a size is width x height in metres, each up to 20. A name has a letter, and neither
/// a semicolon nor a tab. Blank lines and `#` comment lines do not count.
/// Throws topobag::Error with the file and the line.
ObjectClasses read_object_classes(const std::string& path);

/// Reads the words of a map that has other ones than the queries, a name a line, and gives each a
/// class of its own after those of the catalog, "NAME (map)". Throws topobag::Error with the file
/// and the line.
void add_map_words(const std::string& path, ObjectClasses& classes);

/// As maps keep and check them.
topobag::DescribedCatalog described(const ObjectClasses& classes);

/// Whether a map's own classes come before these: none were asked for.
bool may_adopt(const ObjectClasses& classes);

/// The classes that a map keeps; what it leaves unsaid, and other names of the same classes, as
/// given.
/// @param map  by which messages call them
ObjectClasses adopted(ObjectClasses given, const topobag::DescribedCatalog& kept,
                      const std::string& map);

/// Adds `--classes FILE`, which fills `classes`. Parsing throws topobag::Error.
void add_classes_option(CLI::App& command, ObjectClasses& classes);

/// The library's defaults for objects of these classes: what they take for one another, and no
/// others, may be one object.
topobag::RecognitionOptions recognition_options_for(const ObjectClasses& classes);

}  // namespace program
