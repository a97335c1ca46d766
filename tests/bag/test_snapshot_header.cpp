// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>

#include <topobag/bag/snapshot_header.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a header comes back, and nothing after it is read", "[bag][snapshot]") {
  SnapshotHeader header;
  header.entries = 0x0102030405060708;
  header.catalog_fingerprint = ~std::uint64_t{0};
  header.scalar_bytes = 4;
  const auto bytes = to_bytes(header);
  REQUIRE(bytes.size() == 44);
  std::istringstream stream(std::string(bytes.begin(), bytes.end()) + "rest");
  const SnapshotHeader back = inspect(stream);
  CHECK(back.entries == header.entries);
  CHECK(back.catalog_fingerprint == header.catalog_fingerprint);
  CHECK(back.scalar_bytes == 4);
  CHECK(back.library_version == header.library_version);
  CHECK(to_bytes(back) == bytes);
  std::string rest;
  stream >> rest;
  CHECK(rest == "rest");
}

TEST_CASE("a header is little-endian", "[bag][snapshot]") {
  SnapshotHeader header;
  header.entries = 0x0102030405060708;
  const auto bytes = to_bytes(header);
  CHECK(std::string(bytes.begin(), bytes.begin() + 8) == "\x89TBG\r\n\x1A\n");
  CHECK(bytes[8] == 1);
  CHECK(bytes[9] == 0);
  for (std::size_t i = 0; i < 8; ++i) CHECK(bytes[24 + i] == 8 - i);
}

TEST_CASE("the checksum is the CRC-32 of everybody", "[bag][snapshot]") {
  const std::string text = "123456789";
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  CHECK(detail::crc32(bytes, 9) == 0xCBF43926);
  CHECK(detail::crc32(bytes + 4, 5, detail::crc32(bytes, 4)) == 0xCBF43926);
}
