// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_row.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/adaptors/detail/sqlite_statement.hpp>
#include <topobag/adaptors/sqlite_options.hpp>
#include <topobag/bag/session_number.hpp>
#include <topobag/types/utf8.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Notes a new session, numbered on from the last one of the sessions and of the key frames.
inline std::uint32_t note_session(SqliteConnection& connection, const std::string& name) {
  require_utf8(name, "the session's name");
  const std::int64_t last = sqlite_number(connection,
                                          "SELECT max(coalesce((SELECT max(id) FROM session), -1),"
                                          " coalesce((SELECT max(session) FROM keyframe), -1))");
  const std::uint32_t session =
      last < 0 ? 0 : next_session(sqlite_session(static_cast<double>(last)));
  SqliteStatement(connection, "INSERT INTO session(id, name) VALUES(?, ?)")
      .bind(std::int64_t{session}, name)
      .step();
  return session;
}

/// By rising id.
inline std::vector<MapSession> noted_sessions(const SqliteConnection& connection) {
  std::vector<MapSession> sessions;
  SqliteStatement rows(connection, "SELECT id, name FROM session ORDER BY id");
  while (rows.step()) {
    sessions.push_back({static_cast<std::uint32_t>(rows.integer(0)), rows.text(1)});
  }
  return sessions;
}

/// The runs that another map names; none of a bag that names no runs.
template <typename Other>
auto named_sessions(const Other& other, int) -> decltype(other.sessions()) {
  return other.sessions();
}
template <typename Other>
std::vector<MapSession> named_sessions(const Other&, long) {
  return {};
}

/// Notes runs under numbers that are `offset` higher; where there is one already, it keeps its
/// name.
inline void note_sessions(const SqliteConnection& connection,
                          const std::vector<MapSession>& sessions, std::uint32_t offset) {
  SqliteStatement insert(connection, "INSERT OR IGNORE INTO session(id, name) VALUES(?, ?)");
  for (const MapSession& session : sessions) {
    insert.bind(std::int64_t{session_after(session.id, offset)}, session.name).step();
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
