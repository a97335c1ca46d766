// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>
#include <string_view>

#include <topobag/types/detail/value_lines.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

TEST_CASE("values come line by line, by name or by place", "[types]") {
  detail::ValueLines lines("thing", "topobag thing 2\r\nsize 4\n1 -2.5 7\nend\n");
  CHECK(lines.version(2) == 2);
  CHECK(lines.next_begins("size "));
  CHECK_FALSE(lines.next_begins("size 5"));
  CHECK(lines.number<std::size_t>(lines.behind("size")) == 4);
  std::string_view row = lines.next();
  CHECK(lines.take<int>(row) == 1);
  CHECK(lines.take<double>(row) == -2.5);
  CHECK(lines.take<int>(row) == 7);
  CHECK(row.empty());
  CHECK(error_text([&] { lines.take<int>(row); }) ==
        "thing, line 3: '' is not a number that fits here.");
  CHECK(error_text([&] { lines.require_end(); }).find("line 4: something stands") !=
        std::string::npos);
  CHECK(lines.next() == "end");
  lines.require_end();
}

TEST_CASE("what is not whole or of another kind is refused by the line", "[types]") {
  const auto refused = [](std::string_view text) {
    return error_text([&] { detail::ValueLines("thing", text).version(2); });
  };
  CHECK(refused("") == "thing, line 1: this is no thing.");
  CHECK(refused("topobag things 1\n") == "thing, line 1: this is no thing.");
  CHECK(refused("topobag thing 1") == "thing, line 1: the text is cut off.");
  CHECK(refused("topobag thing 0\n") == "thing, line 1: there is no such version.");
  CHECK(refused("topobag thing 3\n") ==
        "thing, line 1: it is of version 3, later than this library's, 2.");
  detail::ValueLines lines("thing", "sizes 4\n");
  CHECK(error_text([&] { lines.behind("size"); }) ==
        "thing, line 1: 'size' and its value are missing.");
}
