// SPDX-License-Identifier: MIT
#include "path_kind.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <topobag/evaluation/text_lines.hpp>

#include "input_error.hpp"
#include "node_table.hpp"

namespace program {
namespace {

namespace fs = std::filesystem;

bool is_file(const std::string& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

/// Why the system does not open a file; 0 where it does.
int opening_error(const std::string& path) {
  errno = 0;
  const std::ifstream file(path, std::ios::binary);
  return file ? 0 : errno != 0 ? errno : EIO;
}

}  // namespace

PathKind path_kind(const std::string& path) {
  std::error_code none;
  const bool is_table = is_file(set_name(path) + ".frames.csv");
  if (!is_file(path)) {
    if (is_table) return PathKind::table;
    if (fs::is_directory(path, none)) return PathKind::folder;
    const int error = opening_error(path);
    return error == ENOENT ? PathKind::nothing
           : error != 0    ? PathKind::unreadable
                           : PathKind::other;
  }
  if (opening_error(path) != 0) return PathKind::unreadable;
  if (is_object_map(path)) return PathKind::object_map;
  std::ifstream file(path, std::ios::binary);
  std::string beginning(16, '\0');
  file.read(beginning.data(), 16);
  if (beginning.compare(0, 15, "SQLite format 3") == 0) return PathKind::sqlite_map;
  if (beginning.compare(0, 8, "\x89TBG\r\n\x1a\n") == 0) return PathKind::snapshot;
  return set_name(path) != path && is_table ? PathKind::table : PathKind::other;
}

bool is_compressed(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string beginning(4, '\0');
  file.read(beginning.data(), 4);
  return topobag::is_compressed(beginning);
}

bool is_object_map(const std::string& path) {
  if (!is_file(path)) return false;
  std::ifstream file(path, std::ios::binary);
  char first = '\0';
  return file >> first && first == '{';
}

std::string found_at(const std::string& path) {
  switch (path_kind(path)) {
    case PathKind::nothing:
      return "there is no such file, and no table of this name; check the path" + home_hint(path);
    case PathKind::folder:
      return "it is a folder; name a file or a table in it";
    case PathKind::unreadable:
      return "the file cannot be opened: " + std::generic_category().message(opening_error(path));
    case PathKind::table:
      return "it is a table";
    case PathKind::sqlite_map:
    case PathKind::snapshot:
      return "it is a saved map";
    case PathKind::object_map:
      return "it is a map of objects";
    case PathKind::other:
      return "it is neither a table nor a map";
  }
  return "";
}

void require_map(const std::string& path) {
  const PathKind kind = path_kind(path);
  if (kind == PathKind::nothing || kind == PathKind::folder || kind == PathKind::unreadable) {
    throw InputError(path, found_at(path));
  }
}

void require_object_map(const std::string& path, const std::string& wanted) {
  const PathKind kind = path_kind(path);
  if (kind == PathKind::object_map) return;
  const bool lacks =
      kind == PathKind::nothing || kind == PathKind::folder || kind == PathKind::unreadable;
  throw InputError(path, lacks ? found_at(path)
                               : found_at(path) + "; " + wanted + " needs a map of objects, JSON");
}

}  // namespace program
