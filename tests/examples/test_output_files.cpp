// SPDX-License-Identifier: MIT
#include <algorithm>
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
  int seed = 0;
  command.add_option("--map", map, "");
  command.add_option("--seed", seed, "");
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
  for (const std::string half : {".frames.csv", ".nodes.csv"}) {
    const std::string file = folder.path("set" + half);
    CHECK(output_complaint({"--page", file, "--map", folder.path("set")}) ==
          "--page " + file + ": the file is also that of --map; give another name");
  }
}
