// SPDX-License-Identifier: MIT
#pragma once

#include <sqlite3.h>

#include <memory>
#include <string>
#include <system_error>

#include <topobag/adaptors/detail/sqlite_journal.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Throws what SQLite says of the last call that failed: FormatError for a file that is no sound
/// data base, Error with the system's reason for the rest.
[[noreturn]] inline void sqlite_fail(sqlite3* connection, const std::string& path) {
  const int code = sqlite3_errcode(connection) & 0xFF;
  std::string text = path + ": " + sqlite3_errmsg(connection);
  if (code == SQLITE_CORRUPT) throw FormatError(text + "; take another copy");
  if (code == SQLITE_NOTADB) {
    throw FormatError(text + ": it is no SQLite map (a snapshot is for `load`), or damaged; take " +
                      "another copy");
  }
  if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
    throw Error(text + ": another program has it open and is writing to it; wait until that is " +
                "done or end it, then try again");
  }
  if (code == SQLITE_FULL) throw Error(text + "; make room, then try again");
  const std::string journal = sqlite_journal_of(path);
  if ((code == SQLITE_READONLY || code == SQLITE_CANTOPEN) && !journal.empty()) {
    throw Error(path +
                ": it was not closed, and its folder cannot be written, as reading what is " +
                "in " + journal + " needs: copy both files to a folder that can be");
  }
  const int reason = sqlite3_system_errno(connection);
  if (reason != 0 && (code == SQLITE_IOERR || code == SQLITE_CANTOPEN)) {
    text += ": " + std::generic_category().message(reason);
  }
  throw Error(text);
}

/// An open SQLite file.
class SqliteConnection {
 public:
  /// Throws Error when it cannot be opened, and as `require_journal`; without `read_only` it is
  /// made where it is missing.
  SqliteConnection(const std::string& path, bool read_only) : path_(path) {
    // SQLite's names for a data base that goes with its connection.
    if (path.empty() || path == ":memory:") {
      throw Error("'" + path + "' is no file: a map there would be gone at the end; name one");
    }
    require_journal(path);
    if (read_only && sqlite_journal_of(path) == real_path(path) + "-journal") undo_unfinished(path);
    const int flags = read_only ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    sqlite3* opened = nullptr;
    const int status = sqlite3_open_v2(path.c_str(), &opened, flags, nullptr);
    connection_.reset(opened);
    if (status != SQLITE_OK) fail();
    sqlite3_extended_result_codes(get(), 1);
    sqlite3_busy_timeout(get(), 5000);
  }

  sqlite3* get() const noexcept { return connection_.get(); }
  const std::string& path() const noexcept { return path_; }

  /// Runs statements that return nothing. Throws Error.
  void run(const char* sql) const {
    if (sqlite3_exec(get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
  }

  /// Puts what is in the -wal into the file too, as far as no reader is in the way; whether all of
  /// it is there now.
  bool checkpoint() const noexcept {
    int pages = 0, done = -1;
    const int status =
        sqlite3_wal_checkpoint_v2(get(), "main", SQLITE_CHECKPOINT_PASSIVE, &pages, &done);
    return status == SQLITE_OK && pages == done;
  }

  [[noreturn]] void fail() const { sqlite_fail(get(), path_); }

 private:
  /// Takes back what a process was writing when it was killed, which reading alone cannot; where
  /// the folder cannot be written, reading will say so.
  static void undo_unfinished(const std::string& path) {
    try {
      SqliteConnection(path, false).run("SELECT count(*) FROM sqlite_master");
    } catch (const Error&) {
    }
  }

  struct Close {
    /// What was open for writing is left as one file without a journal beside it, which can be
    /// copied, and read where nothing may be written.
    void operator()(sqlite3* connection) const noexcept {
      if (sqlite3_db_readonly(connection, "main") == 0) {
        sqlite3_exec(connection, "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
      }
      sqlite3_close_v2(connection);
    }
  };

  std::string path_;
  std::unique_ptr<sqlite3, Close> connection_;
};

/// A change that is made whole by `commit` or not at all.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(const SqliteConnection& connection) : connection_(connection) {
    connection_.run("BEGIN IMMEDIATE");
  }
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;
  ~SqliteTransaction() {
    // Some errors have rolled back already.
    if (open_ && sqlite3_get_autocommit(connection_.get()) == 0) {
      sqlite3_exec(connection_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
  }

  /// Throws Error; then nothing was changed.
  void commit() {
    connection_.run("COMMIT");
    open_ = false;
  }

 private:
  const SqliteConnection& connection_;
  bool open_ = true;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
