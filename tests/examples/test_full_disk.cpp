// SPDX-License-Identifier: MIT
// No file may grow, as on a full disk: each output stays the old file, and the system's reason is
// told.
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "catch.hpp"
#include "output_writers.hpp"

namespace {

/// Runs the program where a file of more than 0 bytes cannot be written; what it says on stderr
/// comes through a pipe.
ProgramRun run_without_space(const std::string& arguments) {
  const std::string command = std::string("trap '' XFSZ; ulimit -f 0; exec '") + TOPOBAG_PROGRAM +
                              "' " + arguments + " 2>&1 >/dev/null";
  ProgramRun run;
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  for (std::array<char, 256> part; std::fgets(part.data(), part.size(), pipe) != nullptr;) {
    run.err += part.data();
  }
  const int status = ::pclose(pipe);
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return run;
}

/// Everything in a folder is as it was, and nothing else is there.
void check_unchanged(const ScratchFolder& folder, const std::vector<std::string>& names,
                     const std::string& content) {
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    CAPTURE(entry.path().filename().string());
    CHECK(entry.file_size() == content.size());
    ++found;
  }
  CHECK(found == names.size());
  for (const std::string& name : names) CHECK(content_of(folder.path(name)) == content);
}

}  // namespace

TEST_CASE("a full disk leaves tables, reports and lists as they were", "[examples]") {
  const ScratchFolder inputs;
  for (const OutputWriter& writer : output_writers(inputs)) {
    const ScratchFolder folder;
    std::vector<std::string> names;
    for (const WrittenFile& file : writer.files) {
      names.push_back(file.name);
      folder.write(file.name, "old");
    }
    const ProgramRun run = run_without_space(writer.arguments_in(folder.path()));
    CAPTURE(writer.arguments, run.err);
    if (run.err.find("was not built") != std::string::npos) continue;
    CHECK(run.exit_code == 2);
    CHECK(text_ends_with(run.err, " cannot be written: File too large\n"));
    check_unchanged(folder, names, "old");
  }
}

TEST_CASE("a full disk leaves a map as it was, or none", "[examples]") {
  std::vector<std::string> files{"map.bag"};
#ifdef TOPOBAG_HAS_SQLITE
  files.emplace_back("map.db");
#endif
  const std::string thin = " --window 0 --camera 517.3,516.5,318.6,255.3 --keyframe-interval 9 ";
  for (const std::string& file : files) {
    const ScratchFolder folder;
    const std::string map = "map --out " + folder.path(file) + thin;
    const auto check_told = [&](const std::string& arguments) {
      const ProgramRun run = run_without_space(arguments);
      CAPTURE(arguments, run.err);
      CHECK(run.exit_code == 2);
      CHECK(text_ends_with(run.err, ": File too large\n"));
      CHECK(run.err.find("topobag: " + folder.path(file)) == 0);
      CHECK(run.err.find(".part-") == std::string::npos);  // no name that the user gave
    };
    check_told(map + "--nodes " + sample_map);
    check_unchanged(folder, {}, "");
    REQUIRE(run_program(map + "--nodes " + sample_map).exit_code == 0);
    const std::string before = content_of(folder.path(file));
    check_told(map + "--append --nodes " + sample_query);
    check_unchanged(folder, {file}, before);
  }
}
