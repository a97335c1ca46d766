// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "error_text.hpp"
#include "output_files.hpp"
#include "scratch.hpp"

namespace {

/// What is said of a command with a map to read, two files to write and a number.
std::string output_complaint(std::vector<std::string> arguments) {
  CLI::App command;
  std::string map, page, list;
  std::vector<std::string> others;
  int seed = 0;
  command.add_option("--map", map, "");
  command.add_option("--seed", seed, "");
  command.add_option("--other", others, "");
  program::add_output_option(command, "--page", page, "");
  program::add_output_option(command, "--list", list, "");
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  command.parse(std::move(arguments));
  return error_text([&] { program::require_outputs(command); });
}

}  // namespace

TEST_CASE("a file to write has a folder, and is no other option's", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string file = folder.path("f");
  const auto shared = [&](const std::string& option, const std::string& other) {
    return option + ' ' + file + ": the file is also that of " + other + "; give another name";
  };
  CHECK(output_complaint({"--page", file, "--list", folder.path("g"), "--map", folder.path("m")}) ==
        "nothing was thrown");
  CHECK(output_complaint({"--page", file, "--list", file}) == shared("--page", "--list"));
  CHECK(output_complaint({"--list", file, "--map", file}) == shared("--list", "--map"));
  CHECK(output_complaint({"--page", file, "--map", folder.path("./f")}) ==
        shared("--page", "--map"));
  CHECK(output_complaint({"--page", folder.path("no/f")}) ==
        "--page " + folder.path("no/f") + ": the folder does not exist; make it first");
  CHECK(output_complaint({"--page", "7", "--seed", "7"}) == "nothing was thrown");
  CHECK(output_complaint({"--page", "/dev/null", "--list", "/dev/null"}) == "nothing was thrown");
}

TEST_CASE("neither half of a table is written over", "[examples][regression]") {
  const ScratchFolder folder;
  for (const std::string half : {".frames.csv", ".nodes.csv", ".clusters.csv"}) {
    const std::string file = folder.path("set" + half);
    CHECK(output_complaint({"--page", file, "--map", folder.path("set")}) ==
          "--page " + file + ": the file is also that of --map; give another name");
  }
}

TEST_CASE("no file of an option with several is written over", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string file = folder.path("b.nodes.csv");
  CHECK(output_complaint({"--page", file, "--other", folder.path("a"), folder.path("b")}) ==
        "--page " + file + ": the file is also that of --other; give another name");
}

TEST_CASE("pages are not written over a folder or a map", "[examples][regression]") {
  const ScratchFolder folder;
  CHECK(output_complaint({"--page", folder.path()}) ==
        "--page " + folder.path() + ": it is a folder; name a file in it");
  CHECK(output_complaint({"--page", folder.path("new/")}) ==
        "--page " + folder.path("new/") + ": it is a folder; name a file in it");
  for (const std::string& beginning :
       {std::string("\x89TBG\r\n\x1a\n"), std::string("SQLite format 3\0", 16)}) {
    const std::string map = folder.write("map", beginning);
    CHECK(output_complaint({"--page", map}) ==
          "--page " + map + ": it is a map; give another name");
  }
  const std::string page = folder.write("page.html", "<p>");
  CHECK(output_complaint({"--page", page}) == "nothing was thrown");
}

TEST_CASE("a folder that takes no files is told before the work", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string file = folder.path("f");
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read);
  const std::string said = output_complaint({"--page", file});
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
  // The super-user writes everywhere.
  CHECK(said == (::geteuid() == 0 ? "nothing was thrown"
                                  : "--page " + file +
                                        ": it cannot be written into its folder: Permission "
                                        "denied"));
}
