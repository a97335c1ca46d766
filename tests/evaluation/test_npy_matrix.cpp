// SPDX-License-Identifier: MIT
#include <sstream>

#include <topobag/evaluation/npy_matrix.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

template <typename Number>
std::string npy(const std::string& type, const std::string& order, const std::string& shape,
                const std::vector<Number>& numbers, char version = 1,
                std::size_t header_size = 118) {
  std::string dictionary =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  dictionary.resize(header_size - 1, ' ');
  dictionary += '\n';
  std::string file("\x93NUMPY");
  file +=
      {version, '\0', static_cast<char>(header_size % 256), static_cast<char>(header_size / 256)};
  if (version > 1) file += std::string(2, '\0');
  file += dictionary;
  file.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  return file;
}

ScoreMatrix matrix_in(const std::string& file) {
  std::istringstream stream(file);
  return read_npy(stream, "scores.npy");
}

template <typename Number>
void check_type(const std::string& type) {
  const std::vector<Number> numbers{1, 2, 3, 4, 5, 6};
  ScoreMatrix rows(2, 3);
  rows << 1, 2, 3, 4, 5, 6;
  CHECK(matrix_in(npy(type, "False", "(2, 3)", numbers)) == rows);
  CHECK(matrix_in(npy(type, "False", "(2,3)", numbers, 2)) == rows);
  ScoreMatrix columns(2, 3);
  columns << 1, 3, 5, 2, 4, 6;
  CHECK(matrix_in(npy(type, "True", "(2, 3)", numbers, 3)) == columns);
}

}  // namespace

TEST_CASE("matrices of every number type, in rows and in columns", "[evaluation]") {
  check_type<double>("<f8");
  check_type<float>("<f4");
  check_type<std::int64_t>("<i8");
  check_type<std::int32_t>("<i4");
  check_type<std::int16_t>("<i2");
  check_type<std::int8_t>("|i1");
  check_type<std::uint64_t>("<u8");
  check_type<std::uint32_t>("<u4");
  check_type<std::uint16_t>("<u2");
  check_type<std::uint8_t>("|u1");
  CHECK(matrix_in(npy<double>("<f8", "False", "(0, 7)", {})).cols() == 7);
  for (const char version : {char{1}, char{2}}) {  // a header whose length takes more than a byte
    CHECK(matrix_in(npy<double>("<f8", "False", "(1, 2)", {5, 6}, version, 4000))(0, 1) == 6);
  }
}

TEST_CASE("what is not a matrix file is refused", "[evaluation]") {
  const std::vector<double> six{1, 2, 3, 4, 5, 6};
  const std::string good = npy("<f8", "False", "(2, 3)", six);
  for (std::size_t size = 0; size < good.size(); ++size) {
    CHECK_THROWS_AS(matrix_in(good.substr(0, size)), Error);
  }
  CHECK_THROWS_AS(matrix_in(good + '\0'), Error);
  CHECK_THROWS_AS(matrix_in("PK\3\4 an archive"), Error);
  CHECK_THROWS_AS(matrix_in(npy("<f8", "False", "(6,)", six)), Error);
  CHECK_THROWS_AS(matrix_in(npy("<f8", "False", "(1, 2, 3)", six)), Error);
  CHECK_THROWS_AS(matrix_in(npy(">f8", "False", "(2, 3)", six)), Error);
  CHECK_THROWS_AS(matrix_in(npy("<f2", "False", "(2, 3)", six)), Error);
  CHECK_THROWS_AS(matrix_in(npy("<f8", "False", "(-2, 3)", six)), Error);
  CHECK_THROWS_AS(matrix_in(npy("<f8", "False", "(4294967296, 4294967296)", six)), Error);
  CHECK_THROWS_AS(matrix_in(npy("<f8", "False", "(99999999, 99999999)", six)), Error);
  CHECK_THROWS_AS(matrix_in(npy("<f8", "False", "(2, 3)", six, 4)), Error);
  CHECK_THROWS_AS(read_npy("there/is/no/such.npy"), Error);
}
