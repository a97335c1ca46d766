// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/types/class_catalog.hpp>

namespace topobag {
inline namespace v0 {

/// How a map is opened.
struct SqliteOptions {
  bool read_only = false;                 ///< to localize: the file is not touched
  ViewSection views = ViewSection::kept;  ///< whether views are written
  std::optional<ClassCatalog> catalog;    ///< has to be the one that the map was made with
};

/// One run of the robot.
struct MapSession {
  std::uint32_t id = 0;  ///< as in `EntryInfo::session`
  std::string name;      ///< the user's own
};

}  // namespace v0
}  // namespace topobag
