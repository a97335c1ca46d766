// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/adaptors/detail/sqlite_statement.hpp>
#include <topobag/bag/described_catalog.hpp>
#include <topobag/bag/detail/storage/class_traits.hpp>
#include <topobag/error.hpp>
#include <topobag/types/catalog_fingerprint.hpp>
#include <topobag/types/dynamics.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The table of what a map says of its classes beside their names; who knows nothing of it goes on
/// with the map as before.
inline constexpr const char* sqlite_class_table = R"sql(
CREATE TABLE class_trait(
  id INTEGER PRIMARY KEY,
  dynamics INTEGER NOT NULL,
  lookalike INTEGER,
  width REAL,
  height REAL);
)sql";

/// Writes the names of classes and what is said of them.
inline void write_catalog(const SqliteConnection& connection, const DescribedCatalog& classes) {
  connection.run(sqlite_class_table);
  SqliteStatement name(connection, "INSERT INTO class(id, name) VALUES(?, ?)");
  SqliteStatement trait(connection,
                        "INSERT INTO class_trait(id, dynamics, lookalike, width, height)"
                        " VALUES(?, ?, ?, ?, ?)");
  for (const ClassId id : classes.catalog.ids()) {
    const ClassTraits traits = traits_of(classes, id);
    std::optional<double> lookalike, width, height;
    if (traits.lookalike) lookalike = value(*traits.lookalike);
    if (traits.size) {
      width = (*traits.size)[0];
      height = (*traits.size)[1];
    }
    name.bind(std::int64_t{value(id)}, classes.catalog.name(id)).step();
    trait.bind(std::int64_t{value(id)}, traits.dynamics, lookalike, width, height).step();
  }
}

inline ClassId class_in(const SqliteStatement& row, int column) {
  return ClassId{static_cast<std::int32_t>(row.integer(column))};
}

/// Of the catalog that a map was made with, if any.
inline std::optional<std::int64_t> fingerprint_in(const SqliteConnection& connection) {
  SqliteStatement stored(connection, "SELECT value FROM meta WHERE key = 'catalog'");
  if (!stored.step()) return std::nullopt;
  return stored.integer(0);
}

/// The classes that a map keeps with what is said of them; nothing of a map of names alone, as
/// earlier ones are. Throws FormatError when they are damaged.
inline std::optional<DescribedCatalog> read_catalog(const SqliteConnection& connection) {
  if (sqlite_number(connection, "SELECT count(*) FROM sqlite_master WHERE name = 'class_trait'") ==
      0) {
    return std::nullopt;
  }
  try {
    DescribedCatalog classes;
    SqliteStatement names(connection, "SELECT id, name FROM class");
    while (names.step()) classes.catalog.add(class_in(names, 0), names.text(1), Dynamics::low);
    SqliteStatement rows(connection,
                         "SELECT id, dynamics, lookalike, width, height FROM class_trait");
    std::size_t described = 0;
    for (; rows.step(); ++described) {
      ClassTraits traits;
      traits.dynamics = rows.integer(1);
      if (!rows.is_null(2)) traits.lookalike = class_in(rows, 2);
      if (!rows.is_null(3)) traits.size = {rows.number(3).value(), rows.number(4).value_or(0.0)};
      describe_class(classes, class_in(rows, 0), traits);
    }
    if (described != classes.catalog.size()) {
      throw FormatError("it does not say what each of its classes is");
    }
    if (fingerprint_in(connection) != static_cast<std::int64_t>(fingerprint(classes.catalog))) {
      throw FormatError("their names are not those that it was made with");
    }
    return classes;
  } catch (const Error& error) {
    throw FormatError(connection.path() + ": its classes cannot be read: " + error.what());
  }
}

/// Writes the classes into a map that has none, unless that is only read. Throws FormatError when
/// the map was made with others, or says something else of them, or holds key frames of which
/// nobody has said by which catalog their classes are numbered.
inline void agree_on_catalog(SqliteConnection& connection, const DescribedCatalog& classes,
                             bool read_only) {
  const auto ours = static_cast<std::int64_t>(fingerprint(classes.catalog));
  if (const std::optional<std::int64_t> stored = fingerprint_in(connection)) {
    if (*stored != ours) {
      throw FormatError(connection.path() +
                        ": its class numbers mean other names than yours; open it with the catalog "
                        "that it was made with");
    }
    const std::optional<DescribedCatalog> kept = read_catalog(connection);
    if (kept) require_same_classes(*kept, classes, connection.path() + ": ");
    return;
  }
  if (read_only) return;
  if (sqlite_number(connection, "SELECT count(*) FROM keyframe") != 0) {
    throw FormatError(
        connection.path() +
        ": it holds key frames of which it is not said what their class numbers mean; "
        "open it without a catalog, or add them to a new map that has one");
  }
  SqliteTransaction transaction(connection);
  SqliteStatement(connection, "INSERT INTO meta(key, value) VALUES('catalog', ?)")
      .bind(ours)
      .step();
  write_catalog(connection, classes);
  transaction.commit();
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
