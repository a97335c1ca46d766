// SPDX-License-Identifier: MIT
#include <filesystem>
#include <ostream>
#include <string>

#include <topobag/bag/atomic_file.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

TEST_CASE("a file takes its name when it is whole, and else the old one stays", "[bag]") {
  const ScratchFolder folder;
  const std::string path = folder.write("out.txt", "old");
  const auto write = [&](bool commit) {
    AtomicFile file(path);
    std::ostream stream(file.buffer());
    stream << "new" << std::flush;
    CHECK(content_of(path) == "old");
    if (commit) file.commit();
  };
  write(false);
  CHECK(content_of(path) == "old");
  write(true);
  CHECK(content_of(path) == "new");
  const auto files = std::filesystem::directory_iterator(folder.path());
  CHECK(std::distance(begin(files), end(files)) == 1);
  CHECK(error_text([&] { AtomicFile file(folder.path()); }).find("Is a directory") !=
        std::string::npos);
}
