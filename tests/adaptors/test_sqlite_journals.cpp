// SPDX-License-Identifier: MIT
// Maps beside journals that are not theirs, or are none.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>

#include <topobag/adaptors/sqlite.hpp>

#include "adaptors/sqlite_maps.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// A map that was not closed, in two files: `name` and its -wal.
/// @param keyframes  one at a time
void leave_open(const ScratchFolder& folder, const std::string& name, std::uint64_t keyframes) {
  const std::string path = folder.path("being_written.db");
  std::mt19937 random(3);
  {
    SqliteBag<> map(path);
    for (std::uint64_t id = 0; id < keyframes; ++id) {
      map.add(KeyframeId{id}, random_graph(random, 8));
    }
    folder.write(name, content_of(path));
    folder.write(name + "-wal", content_of(path + "-wal"));
  }
  std::filesystem::remove(path);
}

std::size_t size_of_map(const std::string& path) { return SqliteBag<>(path).bag().size(); }

}  // namespace

TEST_CASE("a new map is not made beside the journal of one that is gone", "[sqlite][regression]") {
  for (const std::string ending : {"-wal", "-journal"}) {
    const ScratchFolder folder;
    const std::string path = folder.path("map.db"), journal = path + ending;
    leave_open(folder, "old.db", 3);
    folder.write("map.db" + ending, content_of(folder.path("old.db-wal")));
    const std::string before = content_of(journal);
    for (const SqliteOptions& options : {SqliteOptions{}, read_only()}) {
      CHECK(error_text([&] { SqliteBag<> map(path, options); }) ==
            path + ": a new map cannot be made beside " + journal +
                ", which holds what was last written to a map of this name: put that map back, "
                "delete the journal, or give another name");
    }
    CHECK_FALSE(std::filesystem::exists(path));
    CHECK((content_of(journal) == before));
    std::filesystem::remove(journal);
    CHECK(size_of_map(path) == 0);
  }
}

TEST_CASE("an empty file is no map that a journal belongs to", "[sqlite][regression]") {
  const ScratchFolder folder;
  leave_open(folder, "map.db", 3);
  folder.write("map.db", "");
  CHECK(error_text([&] {
          SqliteBag<> map(folder.path("map.db"));
        }).find("a new map cannot be made beside") != std::string::npos);
  CHECK(std::filesystem::file_size(folder.path("map.db-wal")) > 0);
}

TEST_CASE("a map whose journal was lost in part is refused, not read as it was", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db"), journal = path + "-wal";
  leave_open(folder, "map.db", 30);
  const std::string file = content_of(path), written = content_of(journal);
  std::string changed = written;
  changed[20] = static_cast<char>(changed[20] ^ 1);  // of its header
  for (const std::string& lost :
       {std::string(), written.substr(0, 10), changed, std::string(written.size(), '\0')}) {
    folder.write("map.db", file);
    folder.write("map.db-wal", lost);
    for (const SqliteOptions& options : {SqliteOptions{}, read_only()}) {
      CHECK(error_text([&] { SqliteBag<> map(path, options); }) ==
            path + ": it was not closed, and " + journal +
                ", which holds what was written last, is no journal any more: copy both files");
    }
    CHECK((content_of(path) == file));
    CHECK((content_of(journal) == lost));
  }
  std::filesystem::remove(journal);
  CHECK(error_text([&] { SqliteBag<> map(path, read_only()); }) ==
        path + ": it was not closed, and " + journal +
            ", which holds what was written last, is missing: copy both files");
  folder.write("map.db-wal", written);
  CHECK(size_of_map(path) == 30);
}

TEST_CASE("a map that nothing was written to since it was opened opens again", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  for (const std::size_t before : {std::size_t{0}, std::size_t{1}}) {
    {
      const SqliteBag<> map(path);
      folder.write("new.db", content_of(path));
      folder.write("cut.db", content_of(path));
    }
    CHECK(size_of_map(folder.path("new.db")) == before);  // its -wal may not be there yet
    folder.write("cut.db-wal", "");
    CHECK(size_of_map(folder.path("cut.db")) == before);
    for (const char* copy : {"new.db", "cut.db"}) std::filesystem::remove(folder.path(copy));
    if (before == 0) SqliteBag<>(path).add(KeyframeId{0}, {});
  }
}

TEST_CASE("what goes on after a crash is as safe as what was written before", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  leave_open(folder, "map.db", 3);
  SqliteBag<> map(path);
  map.add(KeyframeId{3}, {});
  folder.write("copy.db", content_of(path));
  folder.write("copy.db-wal", "");
  CHECK_THROWS_AS(SqliteBag<>(folder.path("copy.db")), FormatError);
  folder.write("copy.db-wal", content_of(path + "-wal"));
  CHECK(size_of_map(folder.path("copy.db")) == 4);
}

TEST_CASE("a map of another program's closing has no journal and opens", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  leave_open(folder, "map.db", 3);
  sqlite3* other = nullptr;
  REQUIRE(sqlite3_open(path.c_str(), &other) == SQLITE_OK);
  REQUIRE(sqlite3_exec(other, "SELECT count(*) FROM keyframe", nullptr, nullptr, nullptr) == 0);
  REQUIRE(sqlite3_close(other) == SQLITE_OK);
  REQUIRE_FALSE(std::filesystem::exists(path + "-wal"));
  REQUIRE(content_of(path)[19] == 2);              // in SQLite's header: not as topobag closes it
  for (int reading = 0; reading < 2; ++reading) {  // which makes a journal, of 0 bytes
    CHECK(SqliteBag<>(path, read_only()).bag().size() == 3);
  }
  CHECK(size_of_map(path) == 3);
}

TEST_CASE("a link's journal is that of the file behind it", "[sqlite][regression]") {
  const ScratchFolder folder;
  leave_open(folder, "map.db", 3);
  std::filesystem::create_symlink("map.db", folder.path("link.db"));
  CHECK(SqliteBag<>(folder.path("link.db"), read_only()).bag().size() == 3);
  std::filesystem::create_symlink("new.db", folder.path("to_be.db"));
  SqliteBag<>(folder.path("to_be.db")).add(KeyframeId{0}, {});
  CHECK(size_of_map(folder.path("new.db")) == 1);
}

TEST_CASE("a map that noted no opening is refused where it seems empty", "[sqlite]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  { const SqliteBag<> map(path); }
  detail::SqliteConnection(path, false).run("DELETE FROM meta WHERE key = 'unclosed'");
  std::string file = content_of(path);
  file[18] = file[19] = 2;  // in SQLite's header: it was not closed
  for (const std::string& lost : {std::string(), std::string("SQLite")}) {
    folder.write("map.db", file);
    folder.write("map.db-wal", lost);
    CHECK_THROWS_AS(SqliteBag<>(path), FormatError);
  }
}

TEST_CASE("a map that another program writes says who holds it", "[sqlite][regression]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  { SqliteBag<>(path).add(KeyframeId{0}, {}); }
  const detail::SqliteConnection other(path, false);
  other.run("BEGIN EXCLUSIVE");
  const detail::SqliteConnection map(path, false);
  sqlite3_busy_timeout(map.get(), 0);
  CHECK(error_text([&] { map.run("SELECT count(*) FROM keyframe"); }) ==
        path + ": database is locked: another program has it open and is writing to it; wait " +
            "until that is done or end it, then try again");
}
