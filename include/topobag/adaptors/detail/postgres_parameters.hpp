// SPDX-License-Identifier: MIT
#pragma once

#include <libpq-fe.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/adaptors/fleet/uuid.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A type of PostgreSQL, by the numbers that its catalog `pg_type` gives it and the array of it.
struct PostgresType {
  Oid one, array;
};
inline constexpr PostgresType postgres_bool{16, 1000}, postgres_bytea{17, 1001},
    postgres_int8{20, 1016}, postgres_text{25, 1009}, postgres_float8{701, 1022},
    postgres_uuid{2950, 2951}, postgres_xid8{5069, 271};

/// Values as PostgreSQL's binary format has them.
inline std::string postgres_bytes(std::uint64_t bits, int bytes = 8) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(bits >> (8 * i));
  return text;
}
inline std::string postgres_bytes(std::int64_t number) {
  return postgres_bytes(static_cast<std::uint64_t>(number));
}
inline std::string postgres_bytes(double number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return postgres_bytes(bits);
}
inline std::string postgres_bytes(bool flag) { return std::string(1, flag ? '\1' : '\0'); }
inline std::string postgres_bytes(const std::string& text) { return text; }
inline std::string postgres_bytes(const Uuid& uuid) { return {uuid.begin(), uuid.end()}; }
inline std::string postgres_bytes(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

/// What a statement's $1, $2, … stand for: user-given values go to the server beside its SQL,
/// never in it.
class PostgresParameters {
 public:
  template <typename Value>
  PostgresParameters& add(PostgresType type, const Value& value) {
    return put(type.one, postgres_bytes(value));
  }

  /// An array of what `value_of` makes of each item: a value, or an optional one.
  template <typename Items, typename ValueOf>
  PostgresParameters& add_array(PostgresType type, const Items& items, const ValueOf& value_of) {
    constexpr std::uint64_t dimensions = 1, may_have_nulls = 1, first_index = 1;
    std::string bytes = postgres_bytes(dimensions, 4) + postgres_bytes(may_have_nulls, 4) +
                        postgres_bytes(std::uint64_t{type.one}, 4) +
                        postgres_bytes(std::uint64_t{items.size()}, 4) +
                        postgres_bytes(first_index, 4);
    for (const auto& item : items) append(bytes, value_of(item));
    return put(type.array, std::move(bytes));
  }

  const std::vector<Oid>& types() const noexcept { return types_; }
  const std::vector<std::string>& values() const noexcept { return values_; }

 private:
  PostgresParameters& put(Oid type, std::string bytes) {
    types_.push_back(type);
    values_.push_back(std::move(bytes));
    return *this;
  }

  template <typename Value>
  static void append(std::string& bytes, const Value& value) {
    const std::string element = postgres_bytes(value);
    bytes += postgres_bytes(std::uint64_t{element.size()}, 4) + element;
  }
  template <typename Value>
  static void append(std::string& bytes, const std::optional<Value>& value) {
    constexpr std::uint64_t null = 0xFFFFFFFF;
    if (value) {
      append(bytes, *value);
    } else {
      bytes += postgres_bytes(null, 4);
    }
  }

  std::vector<Oid> types_;
  std::vector<std::string> values_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
