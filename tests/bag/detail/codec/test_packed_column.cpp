// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <topobag/bag/detail/codec/packed_column.hpp>

#include "catch.hpp"

using namespace topobag;
using detail::BitReader;
using detail::BitWriter;
using detail::Column;

TEST_CASE("bits of any width come back in their order", "[bag][codec]") {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    BitWriter writer;
    std::vector<std::pair<std::uint64_t, unsigned>> put;
    for (int i = 0; i < 50; ++i) {
      const auto width = static_cast<unsigned>(random() % 65);
      const std::uint64_t value = width == 0 ? 0 : random() >> (64 - width);
      writer.put(value, width);
      put.emplace_back(value, width);
    }
    const std::vector<std::uint8_t> bytes = writer.take();
    BitReader reader(bytes.data(), bytes.size());
    for (const auto& [value, width] : put) CHECK(reader.get(width) == value);
    CHECK_NOTHROW(reader.finish());
    CHECK_THROWS_AS(reader.get(8), FormatError);
  }
}

TEST_CASE("whole bytes are little-endian", "[bag][codec]") {
  BitWriter writer;
  writer.put(0x0102030405060708, 64);
  CHECK(writer.take() == std::vector<std::uint8_t>{8, 7, 6, 5, 4, 3, 2, 1});
}

TEST_CASE("numbers of either sign come back", "[bag][codec]") {
  std::mt19937_64 random(2);
  BitWriter writer;
  std::vector<std::int64_t> put;
  for (int i = 0; i < 500; ++i) {
    const auto magnitude = static_cast<std::int64_t>(random() >> (6 + random() % 58));
    put.push_back(random() % 2 == 0 ? magnitude : -magnitude);
    writer.put_signed(put.back());
  }
  const std::vector<std::uint8_t> bytes = writer.take();
  BitReader reader(bytes.data(), bytes.size());
  for (const std::int64_t value : put) CHECK(reader.get_signed() == value);
}

TEST_CASE("columns come back, and equal values cost nothing", "[bag][codec]") {
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    Column column(random() % 20);
    for (auto& value : column) value = static_cast<std::int32_t>(random() >> random() % 32);
    BitWriter writer;
    put_column(writer, column);
    const std::vector<std::uint8_t> bytes = writer.take();
    BitReader reader(bytes.data(), bytes.size());
    CHECK(get_column(reader, column.size(), {-(std::int64_t{1} << 31), std::int64_t{1} << 31}) ==
          column);
    CHECK_NOTHROW(reader.finish());
  }
  BitWriter writer;
  put_column(writer, Column(1000, -7));
  CHECK(writer.take().size() == 2);
}

TEST_CASE("a column is refused out of range, too narrow, or cut off", "[bag][codec]") {
  BitWriter writer;
  put_column(writer, {3, 9, 5});
  const std::vector<std::uint8_t> bytes = writer.take();
  const auto read = [&](std::size_t count, detail::ColumnRange range, unsigned min_width) {
    BitReader reader(bytes.data(), bytes.size());
    return get_column(reader, count, range, min_width);
  };
  CHECK(read(3, {3, 9}, 3) == Column{3, 9, 5});
  CHECK_THROWS_AS(read(3, {4, 9}, 0), FormatError);
  CHECK_THROWS_AS(read(3, {3, 8}, 0), FormatError);
  CHECK_THROWS_AS(read(3, {3, 9}, 4), FormatError);
  CHECK_THROWS_AS(read(std::size_t{1} << 60, {3, 9}, 0), FormatError);
}
