// SPDX-License-Identifier: MIT
#include "path_kind.hpp"

#include <filesystem>
#include <string>

#include "catch.hpp"
#include "error_text.hpp"
#include "run_program.hpp"
#include "sample.hpp"

using program::path_kind;
using program::PathKind;

namespace {

/// A folder with one of each thing that a path may name.
struct EachKind {
  ScratchFolder folder;
  std::string snapshot = folder.write("map.db", "\x89TBG\r\n\x1a\n");
  std::string sqlite = folder.write("map", std::string("SQLite format 3\0", 16));
  std::string objects = folder.write("objects.txt", " {\"nodes\": []}");
  std::string note = folder.write("note.db", "Monday");
  std::string table = folder.path("set");
  std::string loop = folder.path("loop");
  std::string nothing = folder.path("none.db");

  EachKind() {
    folder.write("set.frames.csv", "idx,frame,timestamp\n");
    folder.write("set.nodes.csv", "idx,class,conf,u,v,w,h,z\n");
    std::filesystem::create_symlink(loop, loop);
  }
};

}  // namespace

TEST_CASE("what lies at a path is told by what is there, not by its name", "[examples]") {
  const EachKind each;
  CHECK(path_kind(each.snapshot) == PathKind::snapshot);
  CHECK(path_kind(each.sqlite) == PathKind::sqlite_map);
  CHECK(path_kind(each.objects) == PathKind::object_map);
  CHECK(path_kind(each.note) == PathKind::other);
  CHECK(path_kind(each.table) == PathKind::table);
  CHECK(path_kind(each.table + ".nodes.csv") == PathKind::table);
  CHECK(path_kind(each.folder.path()) == PathKind::folder);
  CHECK(path_kind(each.nothing) == PathKind::nothing);
  CHECK(path_kind(each.loop) == PathKind::unreadable);
}

TEST_CASE("a map of objects is told by its content", "[examples]") {
  const EachKind each;
  CHECK(program::is_object_map(each.objects));
  CHECK_FALSE(program::is_object_map(each.note));
  CHECK_FALSE(program::is_object_map(each.table + ".frames.csv"));
  CHECK_FALSE(program::is_object_map(each.folder.write("empty", "")));
  CHECK_FALSE(program::is_object_map(each.folder.path()));
  CHECK_FALSE(program::is_object_map(each.nothing));
}

TEST_CASE("a map of objects is wanted, and another input is named", "[examples][regression]") {
  const EachKind each;
  const auto said = [](const std::string& path) {
    return error_text([&] { program::require_object_map(path, "relate"); });
  };
  const std::string wanted = "; relate needs a map of objects, JSON";
  CHECK(said(each.objects) == "nothing was thrown");
  CHECK(said(each.snapshot) == each.snapshot + ": it is a saved map" + wanted);
  CHECK(said(each.sqlite) == each.sqlite + ": it is a saved map" + wanted);
  CHECK(said(each.table) == each.table + ": it is a table" + wanted);
  CHECK(said(each.note) == each.note + ": it is neither a table nor a map" + wanted);
  CHECK(said(each.nothing) ==
        each.nothing + ": there is no such file, and no table of this name; check the path");
  CHECK(said(each.loop) ==
        each.loop + ": the file cannot be opened: Too many levels of symbolic links");
}

TEST_CASE("commands say what they found in place of a map or a table", "[examples][regression]") {
  const EachKind each;
  const std::string camera = " --camera 517.3,516.5,318.6,255.3 ";
  const std::string none = ": there is no such file, and no table of this name; check the path";
  const std::string links = ": the file cannot be opened: Too many levels of symbolic links";
  const std::string localize = "localize --query " + sample_query + camera + "--map ";
  const std::string folder = each.folder.path();
  CHECK(refusal(localize + each.nothing) == each.nothing + none);
  CHECK(refusal(localize + each.loop) == each.loop + links);
  CHECK(refusal("view " + each.nothing + " --out " + each.folder.path("v.html")) ==
        each.nothing + none);
  CHECK(refusal("view " + folder + " --out " + each.folder.path("v.html")) ==
        folder + ": it is a folder; name a file or a table in it");
  CHECK(refusal("loops --nodes " + folder + camera) ==
        folder + ": it is a folder; name SET of SET.frames.csv and SET.nodes.csv in it");
  CHECK(refusal("info " + each.objects) ==
        each.objects +
            ": it is no saved map, but begins as a map of objects; `topobag map "
            "--clusters --nodes FILE` makes a map of one");
  CHECK(refusal("info " + each.loop) == each.loop + links);
  const std::string relate = camera + "--out " + each.folder.path("r.json");
  CHECK(refusal("relate --map " + sample_map + " --query " + sample_query + relate) ==
        sample_map + ": it is a table; relate needs a map of objects, JSON");
  CHECK(refusal("relate --map " + each.objects + " --query " + each.objects + relate)
            .find(each.objects + ": it is a map of objects; --query is the table of a run") == 0);
}
