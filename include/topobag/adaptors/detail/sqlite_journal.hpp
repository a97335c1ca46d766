// SPDX-License-Identifier: MIT
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The journal that lies beside a map, which then is open or was not closed: what has been written
/// since (-wal) or what was there before (-journal). Empty without one.
inline std::string sqlite_journal_of(const std::string& path) {
  for (const char* ending : {"-wal", "-journal"}) {
    if (std::ifstream(path + ending).good()) return path + ending;
  }
  return {};
}

/// How many key frames the file itself holds, without a journal; -1 when it cannot say. Makes no
/// file beside it, as opening it otherwise does.
inline std::int64_t sqlite_keyframes_in_file(const std::string& path) {
  std::string uri = "file:";
  for (const char c : path) {
    uri += c == '%' ? "%25" : c == '?' ? "%3f" : c == '#' ? "%23" : std::string(1, c);
  }
  uri += "?immutable=1";
  sqlite3* opened = nullptr;
  sqlite3_open_v2(uri.c_str(), &opened, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> connection(opened, sqlite3_close);
  sqlite3_stmt* prepared = nullptr;
  sqlite3_prepare_v2(opened, "SELECT count(*) FROM keyframe", -1, &prepared, nullptr);
  const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> count(prepared, sqlite3_finalize);
  return sqlite3_step(prepared) == SQLITE_ROW ? sqlite3_column_int64(prepared, 0) : -1;
}

/// Throws FormatError for a map that was not closed and whose journal is missing, so that it seems
/// empty. (One with key frames of its own may have been closed by another program.)
inline void require_journal(const std::string& path) {
  constexpr std::streamoff read_version = 19;  // in SQLite's header; 2 = there is a journal
  std::ifstream file(path, std::ios::binary);
  const bool expected = file.seekg(read_version) && file.get() == 2;
  if (!expected || !sqlite_journal_of(path).empty()) return;
  if (sqlite_keyframes_in_file(path) != 0) return;
  throw FormatError(path + ": it was not closed, and " + path +
                    "-wal, which holds what was written last, is missing: copy both files");
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
