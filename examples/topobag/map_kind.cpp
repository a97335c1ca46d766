// SPDX-License-Identifier: MIT
#include "map_kind.hpp"

#include "fleet_address.hpp"
#include "input_error.hpp"
#include "path_kind.hpp"

namespace program {

MapKind kind_of(const std::string& path) {
  switch (path_kind(path)) {
    case PathKind::sqlite_map:
      return MapKind::sqlite;
    case PathKind::snapshot:
      return MapKind::snapshot;
    case PathKind::table:
      throw InputError(path, "it is a table, no map; `topobag map` makes one of it");
    case PathKind::object_map:
      throw InputError(
          path,
          "it is no saved map, but begins as a map of objects; `topobag map --clusters "
          "--nodes FILE` makes a map of one");
    case PathKind::folder:
      throw InputError(path, "it is a folder; name the map in it");
    case PathKind::nothing:
      throw InputError(path, "the file cannot be opened; check the path" + home_hint(path));
    case PathKind::unreadable:
      throw InputError(path, found_at(path));
    case PathKind::other:
      break;
  }
  if (is_compressed(path)) throw InputError(path, "it is compressed; unpack it first");
  throw InputError(path, "it is no map: neither an SQLite map nor a snapshot of topobag");
}

std::string map_kind_text(const std::string& path) {
  if (is_fleet_address(path)) return "fleet's map";
  return kind_of(path) == MapKind::sqlite ? "SQLite map" : "snapshot";
}

}  // namespace program
