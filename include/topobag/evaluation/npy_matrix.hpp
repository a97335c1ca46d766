// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/evaluation/labelled_scores.hpp>
#include <topobag/evaluation/text_lines.hpp>

namespace topobag {
inline namespace v0 {

namespace detail {

/// The header of a .npy file, as far as a matrix needs it.
struct NpyHeader {
  std::string type;  ///< such as "<f8"
  bool fortran_order = false;
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// What follows `'key':` in the header's dictionary; empty without the key.
inline std::string_view npy_value(std::string_view dictionary, const std::string& key) {
  const std::size_t at = dictionary.find('\'' + key + '\'');
  const std::size_t colon = dictionary.find(':', at);
  if (at == std::string_view::npos || colon == std::string_view::npos) return {};
  return trimmed(dictionary.substr(colon + 1));
}

template <typename Stream>
NpyHeader read_npy_header(Stream& stream, const std::string& name) {
  const auto refuse = [&](const char* why) { throw Error(name + " " + why); };
  std::array<unsigned char, 12> start{};
  const auto read = [&](std::size_t from, std::size_t count) {
    stream.read(reinterpret_cast<char*>(start.data() + from), static_cast<std::streamsize>(count));
    if (!stream) refuse("ends within the header of a .npy file.");
  };
  read(0, 8);
  if (std::memcmp(start.data(), "\x93NUMPY", 6) != 0) refuse("is not a .npy file.");
  if (start[6] < 1 || start[6] > 3) refuse("is of a .npy version other than 1, 2 and 3.");
  const std::size_t length_bytes = start[6] == 1 ? 2 : 4;
  read(8, length_bytes);
  std::size_t length = 0;
  for (std::size_t i = length_bytes; i-- > 0;) length = length << 8 | start[8 + i];
  if (length > 65536) refuse("has a .npy header of more than 64 kB.");
  std::string dictionary(length, ' ');
  stream.read(dictionary.data(), static_cast<std::streamsize>(length));
  if (!stream) refuse("ends within the header of a .npy file.");

  NpyHeader header;
  const std::string_view type = npy_value(dictionary, "descr");
  if (type.size() < 2 || type[0] != '\'') refuse("does not hold plain numbers.");
  header.type = type.substr(1, type.find('\'', 1) - 1);
  header.fortran_order = npy_value(dictionary, "fortran_order").substr(0, 4) == "True";
  const std::string_view shape = npy_value(dictionary, "shape");
  const char* at = shape.data();
  const char* const end = at + shape.size();
  const auto require = [&](bool holds) {
    if (!holds) refuse("does not hold a matrix: its shape is not (rows, columns).");
  };
  const auto skip = [&](char wanted) {
    while (at != end && *at == ' ') ++at;
    require(at != end && *at++ == wanted);
    while (at != end && *at == ' ') ++at;
  };
  const auto extent = [&](std::size_t& value) {
    const auto [stop, status] = std::from_chars(at, end, value);
    require(status == std::errc{});
    at = stop;
  };
  skip('(');
  extent(header.rows);
  skip(',');
  extent(header.columns);
  skip(')');
  return header;
}

/// Copies `bytes` of little-endian numbers of one type into the matrix.
template <typename Number>
ScoreMatrix npy_numbers(const NpyHeader& header, const std::vector<char>& bytes) {
  const auto rows = static_cast<Eigen::Index>(header.rows);
  const auto columns = static_cast<Eigen::Index>(header.columns);
  std::vector<Number> numbers(header.rows * header.columns);
  if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  using Rows = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  if (!header.fortran_order) {
    return Eigen::Map<const Rows>(numbers.data(), rows, columns).template cast<double>();
  }
  return Eigen::Map<const Rows>(numbers.data(), columns, rows).transpose().template cast<double>();
}

}  // namespace detail

/// Reads a matrix from NumPy's .npy format, versions 1 to 3, row or column order: little-endian
/// float32/64, signed and unsigned integers, bool. Throws Error for anything else, a short file or
/// bytes left over. The machine is little-endian.
/// @param stream  a `std::istream`
template <typename Stream>
ScoreMatrix read_npy(Stream& stream, const std::string& name) {
  const detail::NpyHeader header = detail::read_npy_header(stream, name);
  const auto load = [&](auto number) {
    using Number = decltype(number);
    const std::size_t limit = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(Number);
    if (header.columns > 0 && header.rows > limit / header.columns) {
      throw Error(name + " claims more numbers than fit into memory.");
    }
    // Grows with what is really there: a false header allocates nothing.
    const std::size_t size = header.rows * header.columns * sizeof(Number);
    std::vector<char> bytes;
    while (bytes.size() <= size && stream) {
      constexpr std::size_t chunk = std::size_t{1} << 20;
      const std::size_t old = bytes.size();
      bytes.resize(old + chunk);
      stream.read(bytes.data() + old, static_cast<std::streamsize>(chunk));
      bytes.resize(old + static_cast<std::size_t>(stream.gcount()));
    }
    if (bytes.size() != size) {
      throw Error(name + (bytes.size() < size ? " ends before" : " goes on after") +
                  " the numbers that its header announces.");
    }
    return detail::npy_numbers<Number>(header, bytes);
  };
  const std::string& type = header.type;
  if (type == "<f8") return load(double{});
  if (type == "<f4") return load(float{});
  if (type == "<i8") return load(std::int64_t{});
  if (type == "<i4") return load(std::int32_t{});
  if (type == "<i2") return load(std::int16_t{});
  if (type == "|i1") return load(std::int8_t{});
  if (type == "<u8") return load(std::uint64_t{});
  if (type == "<u4") return load(std::uint32_t{});
  if (type == "<u2") return load(std::uint16_t{});
  if (type == "|u1" || type == "|b1") return load(std::uint8_t{});
  throw Error(name + " holds numbers of type '" + type +
              "'; save it as little-endian float32 or float64.");
}

/// The same from a file.
/// @param path  a `std::string`, or what else converts to one
template <typename Path = std::string>
ScoreMatrix read_npy(const Path& path) {
  std::ifstream file = open_file(path);
  return read_npy(file, path);
}

}  // namespace v0
}  // namespace topobag
