// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <istream>
#include <ostream>
#include <vector>

#include <topobag/bag/detail/codec/bit_reader.hpp>
#include <topobag/bag/detail/codec/bit_writer.hpp>
#include <topobag/bag/detail/storage/crc32.hpp>
#include <topobag/bag/detail/storage/file_bytes.hpp>
#include <topobag/error.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Length, bytes and checksum of both.
inline void write_record(std::ostream& stream, const std::vector<std::uint8_t>& body) {
  BitWriter length;
  length.put(body.size(), 32);
  std::vector<std::uint8_t> record = length.take();
  record.insert(record.end(), body.begin(), body.end());
  BitWriter checksum;
  checksum.put(crc32(record.data(), record.size()), 32);
  for (const std::uint8_t byte : checksum.take()) record.push_back(byte);
  write_bytes(stream, record);
}

/// The bytes of a record. Throws FormatError when it is cut off or damaged.
inline std::vector<std::uint8_t> read_record(std::istream& stream) {
  const std::vector<std::uint8_t> length = read_bytes(stream, 4);
  std::vector<std::uint8_t> body = read_bytes(stream, BitReader(length.data(), 4).get(32));
  const std::vector<std::uint8_t> checksum = read_bytes(stream, 4);
  const std::uint32_t found = crc32(body.data(), body.size(), crc32(length.data(), 4));
  if (BitReader(checksum.data(), 4).get(32) != found) {
    throw FormatError("its checksum does not fit: it is damaged; take another copy");
  }
  return body;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
