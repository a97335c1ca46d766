// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace program {

/// What lies at a path.
enum class PathKind {
  nothing,
  folder,
  unreadable,  ///< a file that the system does not open
  table,       ///< SET of SET.frames.csv, or one of its files
  sqlite_map,
  snapshot,
  object_map,  ///< JSON, or what begins as it does
  other,
};

/// By the first bytes of a file, whatever its name; a table is what no file has the name of.
PathKind path_kind(const std::string& path);

/// Whether the file is one of gzip or another packer.
bool is_compressed(const std::string& path);

/// Whether a file is a map of objects: by its first character, whatever its name.
bool is_object_map(const std::string& path);

/// What was found, such as "it is a table"; for what cannot be read, the system's reason.
std::string found_at(const std::string& path);

/// Throws InputError for what is none of table, saved map and map of objects.
void require_map(const std::string& path);

/// Throws InputError for what is no map of objects.
/// @param wanted  that needs one, such as "relate"
void require_object_map(const std::string& path, const std::string& wanted);

}  // namespace program
