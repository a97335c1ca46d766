// SPDX-License-Identifier: MIT
#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <topobag/adaptors/detail/sqlite_connection.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A prepared statement; every call throws Error with what SQLite says.
class SqliteStatement {
 public:
  SqliteStatement(const SqliteConnection& connection, const std::string& sql)
      : path_(connection.path()) {
    sqlite3_stmt* prepared = nullptr;
    const int status = sqlite3_prepare_v3(connection.get(), sql.c_str(), -1,
                                          SQLITE_PREPARE_PERSISTENT, &prepared, nullptr);
    statement_.reset(prepared);
    if (status != SQLITE_OK) connection.fail();
  }

  /// Gives the parameters their values, in order, and forgets those of the last run.
  template <typename... Values>
  SqliteStatement& bind(const Values&... values) {
    sqlite3_reset(statement_.get());
    sqlite3_clear_bindings(statement_.get());
    int parameter = 0;
    (require(set(++parameter, values)), ...);
    return *this;
  }

  /// Goes to the next row; false after the last.
  bool step() {
    const int status = sqlite3_step(statement_.get());
    if (status == SQLITE_ROW) return true;
    if (status != SQLITE_DONE) {
      sqlite3_reset(statement_.get());
      fail();
    }
    sqlite3_reset(statement_.get());
    return false;
  }

  // Of the row, columns counted from 0:
  bool is_null(int column) const {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
  }
  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  /// Nothing for NULL. Throws FormatError for what is no number: SQLite would make it a 0.
  std::optional<double> number(int column) const {
    if (is_null(column)) return std::nullopt;
    const int type = sqlite3_column_type(statement_.get(), column);
    if (type != SQLITE_FLOAT && type != SQLITE_INTEGER) {
      throw FormatError("its '" + std::string(sqlite3_column_name(statement_.get(), column)) +
                        "' is '" + text(column) + "', which is no number");
    }
    return sqlite3_column_double(statement_.get(), column);
  }
  std::string text(int column) const {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    return text == nullptr ? std::string()
                           : std::string(text, static_cast<std::size_t>(
                                                   sqlite3_column_bytes(statement_.get(), column)));
  }
  std::vector<std::uint8_t> blob(int column) const {
    const auto* bytes =
        static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_.get(), column));
    return bytes == nullptr ? std::vector<std::uint8_t>()
                            : std::vector<std::uint8_t>(
                                  bytes, bytes + sqlite3_column_bytes(statement_.get(), column));
  }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }
  };

  // Texts and blobs are the caller's until the statement has run.
  int set(int parameter, std::int64_t x) {
    return sqlite3_bind_int64(statement_.get(), parameter, x);
  }
  int set(int parameter, const std::optional<double>& x) {
    return x ? sqlite3_bind_double(statement_.get(), parameter, *x)
             : sqlite3_bind_null(statement_.get(), parameter);
  }
  int set(int parameter, const std::string& x) {
    return sqlite3_bind_text64(statement_.get(), parameter, x.data(), x.size(), SQLITE_STATIC,
                               SQLITE_UTF8);
  }
  int set(int parameter, const std::vector<std::uint8_t>& x) {
    return sqlite3_bind_blob64(statement_.get(), parameter, x.data(), x.size(), SQLITE_STATIC);
  }

  void require(int status) const {
    if (status != SQLITE_OK) fail();
  }
  [[noreturn]] void fail() const { sqlite_fail(sqlite3_db_handle(statement_.get()), path_); }

  std::string path_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
