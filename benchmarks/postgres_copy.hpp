// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <libpq-fe.h>

/// Everything that has been pushed, a line each, as COPY writes and reads it.
inline std::vector<std::string> copied_lines(const std::string& conninfo) {
  PGconn* connection = PQconnectdb(conninfo.c_str());
  PQclear(PQexec(connection, "COPY (SELECT * FROM topobag.version) TO STDOUT (FORMAT text)"));
  std::vector<std::string> lines;
  char* line = nullptr;
  for (int size = 0; (size = PQgetCopyData(connection, &line, 0)) > 0; PQfreemem(line)) {
    lines.emplace_back(line, static_cast<std::size_t>(size));
  }
  PQclear(PQgetResult(connection));
  PQfinish(connection);
  return lines;
}

/// Rows a second of COPY of lines into a table, by one connection, in batches of one transaction
/// each.
inline double copy_lines(const std::string& conninfo, const std::string& table,
                         const std::vector<std::string>& lines, std::size_t batch) {
  PGconn* connection = PQconnectdb(conninfo.c_str());
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  for (std::size_t at = 0; at < lines.size(); at += batch) {
    PQclear(PQexec(connection, ("COPY " + table + " FROM STDIN (FORMAT text)").c_str()));
    for (std::size_t i = at; i < std::min(at + batch, lines.size()); ++i) {
      PQputCopyData(connection, lines[i].data(), static_cast<int>(lines[i].size()));
    }
    PQputCopyEnd(connection, nullptr);
    PGresult* result = PQgetResult(connection);
    if (PQresultStatus(result) != PGRES_COMMAND_OK) {
      throw std::runtime_error(PQerrorMessage(connection));
    }
    PQclear(result);
    PQclear(PQgetResult(connection));
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  PQfinish(connection);
  return static_cast<double>(lines.size()) / seconds;
}
