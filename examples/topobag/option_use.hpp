// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "keyframe.hpp"

namespace program {

/// Throws InputError where an option is given that does nothing without one of `others`, of which
/// the command has one at least.
void require_with(const CLI::App& command, const std::string& option,
                  const std::vector<std::string>& others);

/// The same of the options that say how stress and the vertical are drawn, where neither is asked
/// for.
void require_stress_and_gravity(const CLI::App& command);

/// Throws InputError where it is told which way is up in a world of which no key frame knows its
/// pose.
/// @param set  the key frames' table
void require_vertical(const CLI::App& command, const std::string& set,
                      const std::vector<Keyframe>& keyframes);

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
