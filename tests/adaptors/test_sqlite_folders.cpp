// SPDX-License-Identifier: MIT
// Maps in folders that cannot be written, and maps that were not closed.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <random>
#include <string>

#include <topobag/adaptors/sqlite.hpp>

#include "adaptors/sqlite_maps.hpp"
#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "child_process.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// What `call` returns where nothing but what is everyone's may be written: root may write
/// anywhere.
template <typename Call>
std::string as_nobody(const Call& call) {
  return text_from_child([&] {
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) return std::string{};
    return std::string(call());
  });
}

}  // namespace

TEST_CASE("a map in a folder that cannot be written to is read, not written", "[sqlite]") {
  const ScratchFolder folder;
  std::mt19937 random(10);
  const std::string path = folder.path("map.db");
  { SqliteBag<>(path).add(KeyframeId{5}, random_graph(random, 12)); }
  REQUIRE(::chmod(folder.path().c_str(), 0555) == 0);
  const std::string read = as_nobody(
      [&] { return std::to_string(SqliteBag<>(path, read_only()).bag().size()) + " read"; });
  const std::string written = as_nobody([&] { return error_text([&] { SqliteBag<> map(path); }); });
  REQUIRE(::chmod(folder.path().c_str(), 0755) == 0);
  CHECK(read == "1 read");
  CHECK(written == path + ": attempt to write a readonly database");
  CHECK(SqliteBag<>(path).bag().size() == 1);
}

TEST_CASE("a map that was not closed and lost its journal is refused", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db"), copy = folder.path("copy.db");
  SqliteBag<> map(path);  // open: as after a crash
  map.add(KeyframeId{1}, {});
  folder.write("copy.db", content_of(path));
  const std::string before = content_of(copy);
  for (const SqliteOptions& options : {SqliteOptions{}, read_only()}) {
    CHECK(error_text([&] { SqliteBag<> lost(copy, options); }) ==
          copy + ": it was not closed, and " + copy +
              "-wal, which holds what was written last, is missing: copy both files");
  }
  CHECK(content_of(copy) == before);
  CHECK_FALSE(std::filesystem::exists(copy + "-wal"));
  folder.write("whole.db", content_of(path));
  folder.write("whole.db-wal", content_of(path + "-wal"));
  CHECK(SqliteBag<>(folder.path("whole.db")).bag().size() == 1);
}

TEST_CASE("a map that was not closed is not read in a folder that cannot be written", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  SqliteBag<> map(folder.path("open.db"));
  map.add(KeyframeId{1}, {});
  folder.write("map.db", content_of(folder.path("open.db")));
  folder.write("map.db-wal", content_of(folder.path("open.db-wal")));
  REQUIRE(::chmod(folder.path().c_str(), 0555) == 0);
  const std::string said =
      as_nobody([&] { return error_text([&] { SqliteBag<> closed(path, read_only()); }); });
  REQUIRE(::chmod(folder.path().c_str(), 0755) == 0);
  CHECK(said ==
        path + ": it was not closed, and its folder cannot be written, as reading what is in " +
            path + "-wal needs: copy both files to a folder that can be");
}
