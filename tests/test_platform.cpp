// SPDX-License-Identifier: MIT
#include <bitset>
#include <random>

#include <topobag/platform.hpp>

#include "catch.hpp"
#include "scratch_folder.hpp"

using namespace topobag::detail;

TEST_CASE("bits are counted and found", "[platform]") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t word = random() << random() % 64;
    CHECK(popcount(word) == static_cast<int>(std::bitset<64>(word).count()));
    if (word == 0) continue;
    const std::size_t lowest = lowest_bit(word);
    CHECK(((word >> lowest) & 1) == 1);
    CHECK((lowest == 0 || word << (64 - lowest) == 0));
  }
}

TEST_CASE("a file is made once, written, and takes another's place", "[platform]") {
  const ScratchFolder folder;
  const std::string path = folder.path("a"), old = folder.write("b", "before");
  const int file = create_file(path);
  REQUIRE(file >= 0);
  CHECK(create_file(path) == -1);
  CHECK(errno == EEXIST);
  CHECK(write_some(file, "now", 3) == 3);
  CHECK(sync_file(file) == 0);
  CHECK(close_file(file) == 0);
  CHECK(replace_file(path, old) == 0);
  CHECK(status_of(path).kind == FileStatus::Kind::none);
  CHECK(status_of(old).kind == FileStatus::Kind::regular);
  CHECK(status_of(folder.path("")).kind == FileStatus::Kind::folder);
  CHECK(content_of(old) == "now");
}

TEST_CASE("a folder that is not there cannot be locked", "[platform]") {
  const ScratchFolder folder;
  CHECK(FolderLock(folder.path("")).valid());
  CHECK_FALSE(FolderLock(folder.path("none")).valid());
}
