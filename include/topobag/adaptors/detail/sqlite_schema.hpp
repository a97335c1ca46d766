// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_statement.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {

/// The version of the tables that `SqliteBag` writes; it takes earlier ones along.
inline constexpr std::int64_t sqlite_schema_version = 1;

namespace detail {

inline constexpr std::int64_t sqlite_application = 0x54424147;  // "TBAG"

/// What takes a file from one version of the schema to the next; the first one from nothing.
/// Written once, never changed: a new schema is a new step.
inline constexpr std::array<const char*, sqlite_schema_version> sqlite_migrations = {R"sql(
CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE class(id INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE session(id INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE keyframe(
  id INTEGER PRIMARY KEY,
  session INTEGER NOT NULL,
  stamp REAL,
  label TEXT NOT NULL,
  tx REAL, ty REAL, tz REAL, qx REAL, qy REAL, qz REAL, qw REAL,
  nodes INTEGER NOT NULL,
  edges INTEGER NOT NULL,
  objects TEXT NOT NULL,
  graph BLOB NOT NULL,
  checksum INTEGER NOT NULL);
CREATE INDEX keyframe_of_session ON keyframe(session);
)sql"};

inline std::int64_t sqlite_number(const SqliteConnection& connection, const std::string& sql) {
  SqliteStatement statement(connection, sql);
  return statement.step() ? statement.integer(0) : 0;
}

/// Makes a new file a map, or an older map one of the present schema. Throws FormatError for a data
/// base that is something else or of a later version.
inline void prepare_schema(const SqliteConnection& connection, bool read_only) {
  const auto version = [&] { return sqlite_number(connection, "PRAGMA user_version"); };
  const auto is_ours = [&] {
    return sqlite_number(connection, "PRAGMA application_id") == sqlite_application;
  };
  const bool empty = sqlite_number(connection, "SELECT count(*) FROM sqlite_master") == 0;
  if (!is_ours() && !(empty && !read_only)) {
    throw FormatError(connection.path() + ": it is a data base, but no map of topobag");
  }
  if (version() > sqlite_schema_version) {
    throw FormatError(connection.path() + ": it is a map of a later version of topobag (schema " +
                      std::to_string(version()) + "): update topobag");
  }
  if (version() == sqlite_schema_version) return;
  if (read_only) {
    throw FormatError(connection.path() +
                      ": it is a map of an earlier version of topobag: open it once for writing");
  }
  SqliteTransaction transaction(connection);
  for (auto step = static_cast<std::size_t>(version()); step < sqlite_migrations.size(); ++step) {
    connection.run(sqlite_migrations[step]);
  }
  connection.run(("PRAGMA application_id = " + std::to_string(sqlite_application)).c_str());
  connection.run(("PRAGMA user_version = " + std::to_string(sqlite_schema_version)).c_str());
  transaction.commit();
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
