// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "object_classes.hpp"
#include "object_map.hpp"

namespace program {

/// Adds `--map-words`, `--map-relation`, `--object-deviation` and `--object-scale`, of a map of
/// objects in place of a table. After `--classes`: what they add to
/// the classes goes by those. Parsing throws topobag::Error.
void add_object_map_options(CLI::App& command, ObjectMapOptions& objects, ObjectClasses& classes);

}  // namespace program
