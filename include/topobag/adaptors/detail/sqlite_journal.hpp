// SPDX-License-Identifier: MIT
#pragma once

#include <sqlite3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

#include <topobag/error.hpp>
#include <topobag/platform.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The journal that lies beside a map, which then is open or was not closed: what has been written
/// since (-wal) or what was there before (-journal). Empty without one. A link's lies beside the
/// file behind it.
inline std::string sqlite_journal_of(const std::string& path) {
  const std::string file = real_path(path);
  for (const char* ending : {"-wal", "-journal"}) {
    if (std::ifstream(file + ending).good()) return (file == path ? path : file) + ending;
  }
  return {};
}

/// Whether SQLite takes a file for a write-ahead log: what does not begin as one (magic number and
/// the checksum of the header's first 24 bytes) it passes over without a word.
/// Source: https://www.sqlite.org/fileformat2.html#walformat
inline bool is_write_ahead_log(const std::string& path) {
  std::array<char, 32> bytes{};
  if (!std::ifstream(path, std::ios::binary).read(bytes.data(), 32)) return false;
  const auto word = [&](std::size_t i, bool big_endian) {
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto byte = static_cast<unsigned char>(bytes[4 * i + (big_endian ? k : 3 - k)]);
      number = number << 8U | byte;
    }
    return number;
  };
  const std::uint32_t magic = word(0, true);
  if ((magic & ~1U) != 0x377F0682U) return false;
  std::uint32_t first = 0, second = 0;
  for (std::size_t i = 0; i < 6; i += 2) {
    first += word(i, (magic & 1U) != 0) + second;
    second += word(i + 1, (magic & 1U) != 0) + first;
  }
  return first == word(6, true) && second == word(7, true);
}

/// A number that an SQL query finds in the file itself, without a journal; -1 where it finds none.
/// Makes no file beside it, as opening it otherwise does.
inline std::int64_t sqlite_number_in_file(const std::string& path, const char* sql) {
  std::string uri = "file:";
  for (const char c : path) {
    uri += c == '%' ? "%25" : c == '?' ? "%3f" : c == '#' ? "%23" : std::string(1, c);
  }
  uri += "?immutable=1";
  sqlite3* opened = nullptr;
  sqlite3_open_v2(uri.c_str(), &opened, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> connection(opened, sqlite3_close);
  sqlite3_stmt* prepared = nullptr;
  sqlite3_prepare_v2(opened, sql, -1, &prepared, nullptr);
  const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> row(prepared, sqlite3_finalize);
  return sqlite3_step(prepared) == SQLITE_ROW ? sqlite3_column_int64(prepared, 0) : -1;
}

/// Throws Error where a journal lies beside the name of a map that is not there, or that is of 0
/// bytes: SQLite would take a new map's key frames for the old one's, or delete the journal.
inline void require_no_journal(const std::string& path) {
  const std::string journal = sqlite_journal_of(path);  // first: who makes a map makes it later
  if (journal.empty()) return;
  std::ifstream file(path, std::ios::binary);
  // Who is killed while it makes a map leaves 0 bytes and a -journal that says so.
  const bool made = file && (file.peek() != std::ifstream::traits_type::eof() ||
                             journal.compare(journal.size() - 4, 4, "-wal") != 0);
  if (made) return;
  throw Error(path + ": a new map cannot be made beside " + journal +
              ", which holds what was last written to a map of this name: put that map back, " +
              "delete the journal, or give another name");
}

/// Throws FormatError for a map that was not closed and whose journal is missing or is none, though
/// something was written to it. (What another program closed has no journal either.) A journal that
/// is cut off is as one that a crash left unfinished: nothing tells. Error as `require_no_journal`.
inline void require_journal(const std::string& path) {
  require_no_journal(path);
  constexpr std::streamoff read_version = 19;  // in SQLite's header; 2 = there is a -wal
  std::ifstream file(path, std::ios::binary);
  if (!file.seekg(read_version) || file.get() != 2) return;
  const std::string journal = sqlite_journal_of(path);
  const bool missing = journal.empty();
  if (!missing && (journal != real_path(path) + "-wal" || is_write_ahead_log(journal))) return;
  // As `SqliteFile` notes it; earlier versions of topobag noted nothing. Reading makes a journal of
  // 0 bytes where another program has closed the map.
  const auto written = sqlite_number_in_file(path, "SELECT value FROM meta WHERE key = 'unclosed'");
  const bool holds_nothing =
      missing || std::ifstream(journal).peek() == std::ifstream::traits_type::eof();
  if (written == 0 || (written > 1 && holds_nothing)) return;
  if (written < 0 && sqlite_number_in_file(path, "SELECT count(*) FROM keyframe") != 0) return;
  throw FormatError(path + ": it was not closed, and " + (missing ? path + "-wal" : journal) +
                    ", which holds what was written last, is " +
                    (missing ? "missing" : "no journal any more") + ": copy both files");
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
