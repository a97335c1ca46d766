// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/adaptors/detail/sqlite_statement.hpp>
#include <topobag/error.hpp>
#include <topobag/types/catalog_fingerprint.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Writes the catalog into a map that has none, unless that is only read. Throws FormatError when
/// the map was made with another one, or holds key frames of which nobody has said by which catalog
/// their classes are numbered.
inline void agree_on_catalog(SqliteConnection& connection, const ClassCatalog& catalog,
                             bool read_only) {
  const auto ours = static_cast<std::int64_t>(fingerprint(catalog));
  SqliteStatement stored(connection, "SELECT value FROM meta WHERE key = 'catalog'");
  if (stored.step()) {
    if (stored.integer(0) == ours) return;
    throw FormatError(connection.path() +
                      ": its class numbers mean other names than yours; open it with the catalog "
                      "that it was made with");
  }
  if (read_only) return;
  if (sqlite_number(connection, "SELECT count(*) FROM keyframe") != 0) {
    throw FormatError(connection.path() +
                      ": it holds key frames of which it is not said what their class numbers mean; "
                      "open it without a catalog, or add them to a new map that has one");
  }
  SqliteTransaction transaction(connection);
  SqliteStatement(connection, "INSERT INTO meta(key, value) VALUES('catalog', ?)")
      .bind(ours)
      .step();
  SqliteStatement insert(connection, "INSERT INTO class(id, name) VALUES(?, ?)");
  for (const ClassId id : catalog.ids()) {
    insert.bind(std::int64_t{value(id)}, catalog.name(id)).step();
  }
  transaction.commit();
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
