// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>

#include "catch.hpp"
#include "csv_reader.hpp"

namespace {

/// What stands between two marks, each on a line of its own, with `indent` blanks taken off.
std::string between(const std::string& text, const std::string& begin, const std::string& end,
                    std::size_t indent) {
  const std::size_t first = text.find(begin);
  REQUIRE(first != std::string::npos);
  const std::size_t start = text.find('\n', first) + 1;
  const std::size_t stop = text.rfind('\n', text.find(end, start)) + 1;
  std::istringstream lines(text.substr(start, stop - start));
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    out += (line.size() > indent ? line.substr(indent) : "") + '\n';
  }
  return out;
}

}  // namespace

TEST_CASE("the README shows the example that is compiled", "[examples]") {
  const std::string sources = TOPOBAG_SOURCES;
  const std::string shown = between(program::read_file(sources + "/README.md"), "```cpp", "```", 0);
  const std::string compiled = between(program::read_file(sources + "/examples/01_five_lines.cpp"),
                                       "// README begins", "// README ends", 2);
  CHECK(shown == compiled);
  CHECK(compiled.find("localize(") != std::string::npos);
}
