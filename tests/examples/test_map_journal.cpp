// SPDX-License-Identifier: MIT
#include "map_journal.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

const std::string mapped_desk = "map --nodes " + sample_map + sample_options + "--out ";

}  // namespace

TEST_CASE("a journal is known by the map beside it, or by its first bytes", "[examples]") {
  const ScratchFolder folder;
  folder.write("m.db", std::string("SQLite format 3\0", 16));
  folder.write("set.frames.csv", "idx,timestamp\n");
  for (const std::string ending : {"-wal", "-shm", "-journal"}) {
    CHECK(program::is_map_journal(folder.path("m.db" + ending)));
    CHECK_FALSE(program::is_map_journal(folder.path("set" + ending)));
    CHECK_FALSE(program::is_map_journal(folder.path("none.db" + ending)));
  }
  CHECK_FALSE(program::is_map_journal(folder.path("m.db")));
  CHECK_FALSE(program::is_map_journal("-wal"));
  folder.write("a", std::string("\x37\x7f\x06\x82\x00\x2d\xe2\x18", 8));
  folder.write("b", "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7");
  folder.write("c", "\xd9\xd5\x05\xf9");
  CHECK(program::is_map_journal(folder.path("a")));
  CHECK(program::is_map_journal(folder.path("b")));
  CHECK_FALSE(program::is_map_journal(folder.path("c")));
}

TEST_CASE("a path means the file behind its links", "[examples]") {
  const ScratchFolder folder;
  std::filesystem::create_symlink("later", folder.path("link"));
  std::filesystem::create_symlink(folder.path("link"), folder.path("far"));
  CHECK(program::file_behind(folder.path("far")) == folder.path("later"));
  CHECK(program::file_behind("later") == "later");
  std::filesystem::create_symlink("loop", folder.path("loop"));
  CHECK(program::file_behind(folder.path("loop")) == folder.path("loop"));
}

TEST_CASE("a map is made beside no journal, and nothing is written over one",
          "[examples][regression]") {
  const ScratchFolder folder;
  const std::string map = folder.path("m.db"), journal = folder.write("m.db-wal", "old");
#ifdef TOPOBAG_HAS_SQLITE
  CHECK(refusal(mapped_desk + map) ==
        map + ": a new map cannot be made beside " + journal +
            ", the journal of a map of this name; put that map back, delete the journal, or give "
            "another name");
  CHECK(refusal(mapped_desk + map + " --append").find("beside " + journal) != std::string::npos);
  CHECK(refusal("merge " + folder.path("a.db") + ' ' + folder.path("b.db") + " --out " + map)
            .find("beside " + journal) != std::string::npos);
#endif
  CHECK(content_of(journal) == "old");
  folder.write("m.db", std::string("SQLite format 3\0", 16));
  const std::string said = journal + ": it is a map's journal; give another name";
  const std::string tables =
      " --map " + sample_map + " --query " + sample_query + sample_options + ' ';
  CHECK(refusal(mapped_desk + journal) == "--out " + said);
  for (const std::string option : {"--report", "--report-data", "--pairs", "--svg"}) {
    CHECK(refusal("localize" + tables + option + ' ' + journal) == option + ' ' + said);
  }
  CHECK(refusal("view " + sample_map + " --out " + journal) == "--out " + said);
  CHECK(content_of(journal) == "old");
}

TEST_CASE("a link whose file is not there yet is written through", "[examples][regression]") {
  const ScratchFolder folder;
  std::vector<std::string> names = {"m.bag", "m.html"};
#ifdef TOPOBAG_HAS_SQLITE
  names.push_back("m.db");
#endif
  for (const std::string& name : names) {
    const std::string link = folder.path("to_" + name);
    std::filesystem::create_symlink(name, link);
    const ProgramRun run =
        run_program(name == "m.html" ? "view " + sample_map + sample_options + "--out " + link
                                     : mapped_desk + link);
    CAPTURE(name, run.err);
    CHECK(run.exit_code == 0);
    CHECK(std::filesystem::is_symlink(link));
    CHECK(std::filesystem::is_regular_file(folder.path(name)));
  }
}

TEST_CASE("a circle of links is told in one sentence", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string link = folder.path("a");
  std::filesystem::create_symlink("b", link);
  std::filesystem::create_symlink("a", folder.path("b"));
  const std::string reason = "Too many levels of symbolic links";
  CHECK(refusal(mapped_desk + link) == link + ": " + reason);
  CHECK(refusal("view " + sample_map + sample_options + "--out " + link) == link + ": " + reason);
  CHECK(refusal("info " + link) == link + ": the file cannot be opened: " + reason);
}

TEST_CASE("an empty text is no file's name", "[examples][regression]") {
  const std::string said = " is empty; give it a value, or leave it out";
  const std::string tables = " --query " + sample_query + sample_options;
  CHECK(refusal(mapped_desk + "''") == "--out" + said);
  CHECK(refusal("localize --map ''" + tables) == "--map" + said);
  CHECK(refusal("compare --scores '' --map " + sample_map + tables) == "--scores" + said);
  CHECK(refusal("info ''") == "map" + said);
}
