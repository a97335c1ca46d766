// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <topobag/adaptors/detail/sqlite_connection.hpp>
#include <topobag/adaptors/detail/sqlite_row.hpp>
#include <topobag/adaptors/detail/sqlite_schema.hpp>
#include <topobag/adaptors/detail/sqlite_statement.hpp>
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

}  // namespace detail
}  // namespace v0
}  // namespace topobag
