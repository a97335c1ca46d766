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

TEST_CASE("a file behind a link is written, whether it is there yet or not", "[bag][regression]") {
  const ScratchFolder folder;
  std::filesystem::create_symlink("out.txt", folder.path("link"));
  std::filesystem::create_symlink(folder.path("link"), folder.path("far"));
  for (const std::string content : {"first", "second"}) {
    AtomicFile file(folder.path("far"));
    std::ostream(file.buffer()) << content << std::flush;
    file.commit();
    CHECK(content_of(folder.path("out.txt")) == content);
    CHECK(std::filesystem::is_symlink(folder.path("far")));
    CHECK(std::filesystem::is_symlink(folder.path("link")));
  }
  std::filesystem::create_symlink("loop", folder.path("loop"));
  CHECK_THROWS_AS(AtomicFile(folder.path("loop")), Error);
  CHECK(std::filesystem::is_symlink(folder.path("loop")));
}
