// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>
#include <vector>

#include <topobag/evaluation/text_lines.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

/// The lines that a reader sees of a text.
std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  TextLines lines(stream, "a.txt");
  std::vector<std::string> all;
  for (std::string_view line; lines.next(line);) {
    all.push_back(std::to_string(lines.number()) + ":" + std::string(line));
  }
  return all;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string_view> fields;
  TextLines::split(line, fields);
  return {fields.begin(), fields.end()};
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("byte-order mark, line ends, blanks and comments do not matter", "[evaluation]") {
  CHECK(lines_of("\xEF\xBB\xBF 1 2 \r\n\r\n# 3\n\t\n  # 4\n5") == Texts{"1:1 2", "6:5"});
  CHECK(lines_of("\xEF\xBB\xBF# head\n1\n") == Texts{"2:1"});
  CHECK(lines_of("").empty());
}

TEST_CASE("fields lie between commas where there is one, else between blanks", "[evaluation]") {
  CHECK(fields_of("1  2\t3") == Texts{"1", "2", "3"});
  CHECK(fields_of("1, 2 ,3") == Texts{"1", "2", "3"});
  CHECK(fields_of("my tv,,2") == Texts{"my tv", "", "2"});
  CHECK(fields_of("one") == Texts{"one"});
}

TEST_CASE("what is no text is refused with its line", "[evaluation]") {
  const auto complaint = [](const std::string& text) {
    return error_text([&] { lines_of(text); });
  };
  for (const std::string mark :
       {"\x1F\x8B\x08\r", "PK\x03\x04", "BZh9", "\xFD\x37zXZ", "\x28\xB5\x2F\xFD"}) {
    CHECK(is_compressed(mark));
    CHECK(complaint(mark + "\n1 2\n") == "a.txt:1: this is compressed: unpack it first");
    CHECK(complaint("1 2\n" + mark + "\n").find("compressed") == std::string::npos);
  }
  CHECK_FALSE(is_compressed("1 2"));
  CHECK_FALSE(is_compressed("P"));
  CHECK(complaint("1\n\x01\x02\n") == "a.txt:2: this is no text; is it the right file?");
  CHECK(complaint(std::string("1\0", 2)) == "a.txt:1: this is no text; is it the right file?");
  CHECK(complaint("\xFF\xFE"
                  "1") == "a.txt:1: this is UTF-16: save it as UTF-8");
}

TEST_CASE("a complaint of what a line holds gets file and line", "[evaluation]") {
  std::istringstream stream("1 2\nx 2\n1,,2\n");
  TextLines lines(stream, "a.txt");
  std::string_view line;
  std::vector<double> numbers;
  REQUIRE(lines.next(line));
  lines.numbers(line, numbers);
  CHECK(numbers == std::vector<double>{1, 2});
  CHECK(lines.located([] { return 7; }) == 7);
  CHECK(error_text([&] { lines.located([] { throw InvalidValue("it is wrong"); }); }) ==
        "a.txt:1: it is wrong");
  REQUIRE(lines.next(line));
  CHECK(error_text([&] { lines.numbers(line, numbers); }) == "a.txt:2: 'x' is not a number.");
  REQUIRE(lines.next(line));
  CHECK(error_text([&] { lines.numbers(line, numbers); }).find("a number is missing") !=
        std::string::npos);
}

TEST_CASE("an old Mac's line ends are told from what is no text", "[evaluation][regression]") {
  for (const std::string text : {"1 2\r3 4\r", "# head\r1 2\r"}) {
    CHECK(error_text([&] { lines_of(text); }) ==
          "a.txt:1: the lines end as on an old Mac, by CR alone: save the file with LF or CR LF");
  }
  CHECK(lines_of("1\r\r\n2\r\n") == Texts{"1:1", "2:2"});
}

TEST_CASE("separators that are none are told with what to write", "[evaluation][regression]") {
  const auto told = [](const std::string& text) {
    std::istringstream stream(text);
    TextLines lines(stream, "a.txt");
    std::string_view line;
    std::vector<double> numbers;
    REQUIRE(lines.next(line));
    return error_text([&] { lines.numbers(line, numbers); });
  };
  CHECK(told("1;2;3\n") ==
        "a.txt:1: '1;2;3' is not a number: separate numbers by commas or blanks, not semicolons, "
        "and write 0.5, not 0,5.");
  CHECK(told("0,5;1,5\n").find("'5;1' is not a number: separate numbers by commas or blanks") !=
        std::string::npos);
  CHECK(told("0,033 1,5 2,0\n") ==
        "a.txt:1: '033 1' is not a number: separate numbers by commas or by blanks, not by both, "
        "and write 0.5, not 0,5.");
  CHECK(told("query one,2\n") == "a.txt:1: 'query one' is not a number.");
}

TEST_CASE("a file that does not open is told with the system's reason",
          "[evaluation][regression]") {
  CHECK(error_text([] { open_file("/no/where.csv"); }) ==
        "/no/where.csv cannot be opened for reading: No such file or directory.");
  CHECK(error_text([] { open_file("/"); }) == "/ cannot be opened for reading: Is a directory.");
}

TEST_CASE("the last comment above a line is kept", "[evaluation]") {
  std::istringstream stream("1\n# a\n#  b \r\n2\n3\n");
  TextLines lines(stream, "a.txt");
  std::string_view line;
  CHECK(lines.heading().empty());
  for (const std::string heading : {"", "#  b", "#  b"}) {
    REQUIRE(lines.next(line));
    CHECK(lines.heading() == heading);
  }
}

TEST_CASE("a trajectory reads alike with commas, a mark, Windows' line ends and plus signs",
          "[evaluation]") {
  std::istringstream stream("\xEF\xBB\xBF# t x\r\n+1.0,0,0,0,0,0,0,1\r\n\r\n2 1 0 0 0 0 0 1\r\n");
  const Trajectory trajectory = read_tum(stream, "a.txt");
  REQUIRE(trajectory.size() == 2);
  CHECK(trajectory[0].stamp == 1.0);
  CHECK(trajectory[1].T_world_body.translation().x() == 1.0);
  std::istringstream nanoseconds("1305031102175304000 0 0 0 0 0 0 1\n");
  CHECK(error_text([&] { read_tum(nanoseconds, "ns.txt"); }).find("ns.txt:1: the time stamp") == 0);
}
