// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <topobag/adaptors/sqlite.hpp>

inline topobag::SqliteOptions read_only() {
  topobag::SqliteOptions options;
  options.read_only = true;
  return options;
}

/// What the first row of an SQL query says.
inline std::string ask(const std::string& path, const std::string& sql) {
  const topobag::detail::SqliteConnection connection(path, false);
  topobag::detail::SqliteStatement statement(connection, sql);
  return statement.step() ? statement.text(0) : "no row";
}
