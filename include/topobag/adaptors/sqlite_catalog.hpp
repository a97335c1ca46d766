// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <topobag/adaptors/detail/sqlite_catalog.hpp>
#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/bag/described_catalog.hpp>

namespace topobag {
inline namespace v0 {

/// The classes that an SQLite map keeps, without its key frames: nothing where it was made without
/// a catalog, or by a topobag that kept the names alone. The file is not touched. Throws Error when
/// it cannot be opened, FormatError when it is damaged or no map. O(classes).
inline std::optional<DescribedCatalog> sqlite_catalog(const std::string& path) {
  const detail::SqliteConnection connection(path, true);
  detail::prepare_schema(connection, true);
  return detail::read_catalog(connection);
}

}  // namespace v0
}  // namespace topobag
