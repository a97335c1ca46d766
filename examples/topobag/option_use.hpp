// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace program {

/// Throws InputError where an option is given that does nothing without one of `others`.
void require_with(const CLI::App& command, const std::string& option,
                  const std::vector<std::string>& others);

/// Throws InputError where one of the options is given, and says why not.
void require_without(const CLI::App& command, const std::vector<std::string>& options,
                     const std::string& why);

/// Throws InputError where an option of a map of objects is given, and none of the paths is one, or
/// a saved map that was made of one.
void require_object_options(const CLI::App& command, const std::vector<std::string>& paths);

/// Throws InputError where one of the options is given that make key frames of a table, and the map
/// is saved, whose key frames are made.
void require_table_options(const CLI::App& command, const std::string& map);

}  // namespace program
