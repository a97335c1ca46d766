// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/graph_codec.hpp>

namespace topobag {
inline namespace v0 {

/// How a map is opened.
struct SqliteOptions {
  bool read_only = false;                 ///< to localize: the file is not touched
  ViewSection views = ViewSection::kept;  ///< whether views are written
  /// Has to be the one that the map was made with: in names, and in what both say of its classes.
  /// A `ClassCatalog` will do.
  std::optional<DescribedCatalog> catalog;
};

/// One run of the robot.
struct MapSession {
  std::uint32_t id = 0;  ///< as in `EntryInfo::session`
  std::string name;      ///< the user's own
};

}  // namespace v0
}  // namespace topobag
