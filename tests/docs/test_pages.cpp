// SPDX-License-Identifier: MIT
// The README and the pages in examples/docs: their C++ is compiled, their links lead somewhere.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "catch.hpp"

namespace {

namespace fs = std::filesystem;
const fs::path sources(TOPOBAG_SOURCES);

/// The lines of a file without the blanks around them; empty lines are left out.
std::vector<std::string> lines_of(const fs::path& path) {
  std::vector<std::string> lines;
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) {
    const auto begin = line.find_first_not_of(' ');
    if (begin != std::string::npos) {
      lines.push_back(line.substr(begin, line.find_last_not_of(' ') + 1 - begin));
    }
  }
  return lines;
}

std::vector<fs::path> files_of(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  return files;
}

struct PageLine {
  fs::path page;
  std::string text;
  std::string language;  ///< of the code block that it stands in; empty outside
};

std::vector<PageLine> page_lines() {
  std::vector<fs::path> pages = files_of(sources / "examples/docs", ".md");
  pages.push_back(sources / "README.md");
  std::vector<PageLine> lines;
  for (const fs::path& page : pages) {
    std::string language;
    for (const std::string& line : lines_of(page)) {
      if (line.rfind("```", 0) == 0) {
        language = line.substr(3);
      } else {
        lines.push_back({page, line, language});
      }
    }
  }
  return lines;
}

}  // namespace

TEST_CASE("every line of C++ in the pages is compiled by a test or an example", "[docs]") {
  std::set<std::string> compiled;
  for (const char* folder : {"tests/docs", "examples"}) {
    for (const fs::path& file : files_of(sources / folder, ".cpp")) {
      for (const std::string& line : lines_of(file)) compiled.insert(line);
    }
  }
  std::size_t checked = 0;
  for (const PageLine& line : page_lines()) {
    if (line.language != "cpp") continue;
    INFO(line.page << ": " << line.text);
    CHECK(compiled.count(line.text) == 1);
    ++checked;
  }
  CHECK(checked > 50);
}

TEST_CASE("every link in the pages leads to a file", "[docs]") {
  const std::regex link(R"(\]\(([^)#]+)[^)]*\))");
  std::size_t checked = 0;
  for (const PageLine& line : page_lines()) {
    if (!line.language.empty()) continue;
    for (std::sregex_iterator it(line.text.begin(), line.text.end(), link), end; it != end; ++it) {
      const std::string target = (*it)[1];
      if (target.rfind("http", 0) == 0) continue;
      INFO(line.page << ": " << target);
      CHECK(fs::exists(line.page.parent_path() / target));
      ++checked;
    }
  }
  CHECK(checked > 10);
}
