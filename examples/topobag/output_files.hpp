// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace program {

/// Adds an option that names a file to write.
CLI::Option* add_output_option(CLI::App& command, const std::string& name, std::string& file,
                               const std::string& description);

/// Throws InputError where the folder of a file, which an option names, does not exist or cannot be
/// written into, and where no file is named.
void require_folder(const std::string& option, const std::string& file);

/// The same, and where the file is a folder itself, the name of a table, which would then be taken
/// for the file, or the journal of an SQLite map.
void require_file(const std::string& option, const std::string& file);

/// Throws InputError where an option of the command, or of one within it, has an empty text.
void require_values(const CLI::App& command);

/// Throws InputError, before any work is done, where a file to write has no folder, or is one that
/// another option of the command reads or writes, or a saved map, which pages and lists are not
/// written over. Devices may be named more than once.
void require_outputs(const CLI::App& command);

/// Whether both names are of one file, which is there.
bool are_same_file(const std::string& a, const std::string& b);

}  // namespace program
