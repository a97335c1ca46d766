// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "catch.hpp"
#include "csv_reader.hpp"
#include "error_text.hpp"
#include "scratch.hpp"

using program::CsvReader;

namespace {

/// What reading column "x" of every row as a number throws.
std::string error_of(const std::string& text) {
  const ScratchFolder folder;
  const std::string file = folder.write("t.csv", text);
  return error_in(folder, [&] {
    CsvReader csv(file);
    const std::size_t x = csv.column("x");
    while (csv.next()) csv.number(x);
  });
}

}  // namespace

TEST_CASE("columns are found by name, whatever their order", "[examples]") {
  const ScratchFolder folder;
  CsvReader csv(folder.write("t.csv", "name,x,extra\na,1.5,?\nb,-2e3,\n"));
  const std::size_t x = csv.column("x");
  const std::size_t name = csv.column("name");
  CHECK_FALSE(csv.find_column("y"));
  REQUIRE(csv.next());
  CHECK(csv.text(name) == "a");
  CHECK(csv.number(x) == 1.5);
  REQUIRE(csv.next());
  CHECK(csv.text(name) == "b");
  CHECK(csv.number(x) == -2000.0);
  CHECK_FALSE(csv.next());
  CHECK_FALSE(csv.next());
}

TEST_CASE("line ends, blanks, empty lines and a byte order mark do not matter", "[examples]") {
  const ScratchFolder folder;
  CsvReader csv(folder.write("t.csv", "\xEF\xBB\xBFx , y\r\n\r\n 1 ,\t2\r\n\n3,4"));
  std::vector<std::int64_t> values;
  while (csv.next()) {
    values.push_back(csv.integer(csv.column("x")));
    values.push_back(csv.integer(csv.column("y")));
  }
  CHECK(values == std::vector<std::int64_t>{1, 2, 3, 4});
}

TEST_CASE("tabs alone part a row that has them", "[examples][regression]") {
  const ScratchFolder folder;
  CsvReader csv(folder.write("t.csv", "x\tname\ty\n1\tcell phone\t2\n3\t\t4\n5 cup 6\n"));
  std::vector<std::string> names;
  std::vector<std::int64_t> values;
  while (csv.next()) {
    names.emplace_back(csv.text(csv.column("name")));
    values.push_back(csv.integer(csv.column("x")));
    values.push_back(csv.integer(csv.column("y")));
  }
  CHECK(names == std::vector<std::string>{"cell phone", "", "cup"});
  CHECK(values == std::vector<std::int64_t>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("a bad CSV file is refused with file, line and reason", "[examples]") {
  CHECK(error_of("") == "t.csv: the file is empty; a header row is needed");
  CHECK(error_of("\n\n") == "t.csv: the file is empty; a header row is needed");
  CHECK(error_of("a,b\n1,2\n") == "t.csv:1: there is no column 'x'; the header names 'a' 'b'");
  std::string wide = "c0";
  for (int i = 1; i < 14; ++i) wide += ",c" + std::to_string(i);
  CHECK(error_of(wide + "\n").find("'c10' 'c11' and 2 more") != std::string::npos);
  CHECK(error_of("x,y\n1,2\nx,y\n3,4\n") ==
        "t.csv:3: the header stands here again; a file holds one table");
  CHECK(error_of("\x1F\x8B\x08 a\r\n") == "t.csv:1: this is compressed: unpack it first");
  CHECK(error_of("x,y,x\n") == "t.csv:1: the header names column 'x' twice");
  CHECK(error_of("x,y\n1,2\n3\n") == "t.csv:3: the row has 1 fields, the header 2");
  CHECK(error_of("x,y\n1,2,3\n") == "t.csv:2: the row has 3 fields, the header 2");
  CHECK(error_of("x,y\n\n\n\"1\",2\n") ==
        "t.csv:4: a field stands in quotes; write fields without, and none with a comma in it");
}

TEST_CASE("numbers are finite and whole fields", "[examples]") {
  for (const std::string bad :
       {"", "nan", "NaN", "inf", "-inf", "1e999", "1.5px", "0x10", "1 2", "one", "--1"}) {
    CHECK(error_of("x,y\n" + bad + ",0\n") ==
          "t.csv:2: column 'x' holds '" + bad + "', which is not a finite number");
    CHECK_FALSE(program::parse_number(bad));
  }
  CHECK(program::parse_number("-1.25e2") == -125.0);
}

TEST_CASE("integers are whole numbers that fit", "[examples]") {
  const ScratchFolder folder;
  for (const std::string bad : {"1.5", "", "9223372036854775808", "x"}) {
    CsvReader csv(folder.write("t.csv", "i,j\n" + bad + ",0\n"));
    REQUIRE(csv.next());
    CHECK(error_in(folder, [&] { csv.integer(0); }) ==
          "t.csv:2: column 'i' holds '" + bad + "', which is not an integer");
  }
}

TEST_CASE("a table between semicolons is told", "[examples][regression]") {
  const std::string told =
      "columns are separated by commas, not semicolons, and decimals have a point";
  CHECK(error_of("x;y\n1;2\n") == "t.csv:1: " + told);
  CHECK(error_of("x,y\r1,2\r") ==
        "t.csv:1: the lines end as on an old Mac, by CR alone: save the file with LF or CR LF");
}

TEST_CASE("a missing CSV file is named", "[examples]") {
  const ScratchFolder folder;
  CHECK(error_in(folder, [&] { CsvReader csv(folder.path("")); }) ==
        ": it is a folder; name a file in it");
  CHECK(error_text([] { program::write_file("/dev/full", "text"); }) ==
        "/dev/full: it cannot be written: No space left on device");
  CHECK(error_in(folder, [&] { CsvReader csv(folder.path("none.csv")); }) ==
        "none.csv: the file cannot be opened; check the path");
  CHECK(error_in(folder, [&] { program::write_file(folder.path("no/where"), ""); }) ==
        "no/where cannot be written: No such file or directory");
}
