// SPDX-License-Identifier: MIT
#pragma once

#include <libpq-fe.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <topobag/adaptors/fleet/uuid.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The rows that came of a statement, in PostgreSQL's binary format. Every reader throws
/// FormatError for a value of another length than its type has: servers are not trusted.
class PostgresResult {
 public:
  explicit PostgresResult(PGresult* result) : result_(result) {}

  PGresult* get() const noexcept { return result_.get(); }
  int rows() const noexcept { return PQntuples(get()); }
  /// Rows that an INSERT put in.
  std::size_t changed() const { return std::strtoull(PQcmdTuples(get()), nullptr, 10); }

  bool is_null(int row, int column) const { return PQgetisnull(get(), row, column) != 0; }

  std::uint64_t bits(int row, int column) const {
    const std::uint8_t* bytes = fixed(row, column, 8);
    std::uint64_t number = 0;
    for (int i = 0; i < 8; ++i) number = number << 8 | bytes[i];
    return number;
  }
  std::int64_t integer(int row, int column) const {
    return static_cast<std::int64_t>(bits(row, column));
  }
  std::optional<double> number(int row, int column) const {
    if (is_null(row, column)) return std::nullopt;
    const std::uint64_t representation = bits(row, column);
    double number = 0.0;
    std::memcpy(&number, &representation, sizeof number);
    return number;
  }
  bool flag(int row, int column) const { return *fixed(row, column, 1) != 0; }
  Uuid uuid(int row, int column) const {
    Uuid uuid;
    std::copy_n(fixed(row, column, uuid.size()), uuid.size(), uuid.begin());
    return uuid;
  }
  std::vector<std::uint8_t> bytes(int row, int column) const {
    const std::uint8_t* first = raw(row, column);
    return {first, first + length(row, column)};
  }
  std::string text(int row, int column) const {
    const std::uint8_t* first = raw(row, column);
    return {first, first + length(row, column)};
  }

 private:
  struct Clear {
    void operator()(PGresult* result) const noexcept { PQclear(result); }
  };

  std::size_t length(int row, int column) const {
    return static_cast<std::size_t>(PQgetlength(get(), row, column));
  }
  const std::uint8_t* raw(int row, int column) const {
    if (row >= rows() || column >= PQnfields(get())) {
      throw FormatError("the server's answer lacks row " + std::to_string(row) + ", column " +
                        std::to_string(column) + ": it is no PostgreSQL server that topobag knows");
    }
    return reinterpret_cast<const std::uint8_t*>(PQgetvalue(get(), row, column));
  }
  const std::uint8_t* fixed(int row, int column, std::size_t size) const {
    const std::uint8_t* bytes = raw(row, column);
    if (!is_null(row, column) && length(row, column) == size) return bytes;
    throw FormatError("the server's answer holds " + std::to_string(length(row, column)) +
                      " bytes in column '" + PQfname(get(), column) + "' where " +
                      std::to_string(size) + " are due");
  }

  std::unique_ptr<PGresult, Clear> result_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
