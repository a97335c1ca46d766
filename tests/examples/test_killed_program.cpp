// SPDX-License-Identifier: MIT
// The program is killed at any moment: each of its outputs is then the old file or the new one.
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "child_process.hpp"
#include "long_rounds.hpp"
#include "output_writers.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Runs the program for `time`, then kills it.
void run_and_kill(const std::string& arguments, Clock::duration time) {
  const std::string command =
      std::string("exec '") + TOPOBAG_PROGRAM + "' " + arguments + " >/dev/null 2>&1";
  ChildProcess child([&](const auto&) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
  });
  std::this_thread::sleep_for(time);
  child.kill();
}

/// How often files were found old, new, and beside an unfinished one.
struct Findings {
  std::size_t kept = 0, replaced = 0, interrupted = 0;
};

/// Kills the writer again and again over files that say "old".
Findings kill(const OutputWriter& writer, unsigned kills, std::mt19937& random) {
  const ScratchFolder whole;
  const auto start = Clock::now();
  const ProgramRun run = run_program(writer.arguments_in(whole.path()));
  const std::chrono::duration<double> taken = Clock::now() - start;
  CAPTURE(writer.arguments, run.err);
  Findings findings;
  if (run.err.find("was not built") != std::string::npos) return findings;
  REQUIRE(run.exit_code == 0);
  for (unsigned i = 0; i < kills; ++i) {
    const ScratchFolder folder;
    for (const WrittenFile& file : writer.files) folder.write(file.name, "old");
    // Most of the time nothing is written yet: rather late than early.
    const double share = std::uniform_real_distribution<>(i % 4 == 0 ? 0.0 : 0.8, 1.1)(random);
    run_and_kill(writer.arguments_in(folder.path()),
                 std::chrono::duration_cast<Clock::duration>(share * taken));
    for (const WrittenFile& file : writer.files) {
      const std::string found = content_of(folder.path(file.name));
      const bool is_new =
          file.is_whole ? file.is_whole(found) : found == content_of(whole.path(file.name));
      CAPTURE(file.name, found.size());
      CHECK((found == "old" || is_new));
      ++(is_new ? findings.replaced : findings.kept);
    }
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      if (entry.path().filename().string().find(".part-") != std::string::npos) {
        ++findings.interrupted;
      }
    }
  }
  return findings;
}

}  // namespace

TEST_CASE("a killed program leaves tables, reports and lists whole", "[examples][long]") {
  const ScratchFolder inputs;
  std::mt19937 random(1);
  Findings sum;
  for (const OutputWriter& writer : output_writers(inputs)) {
    const Findings found = kill(writer, long_rounds(50), random);
    sum.kept += found.kept;
    sum.replaced += found.replaced;
    sum.interrupted += found.interrupted;
  }
  CHECK(sum.kept > 0);
  CHECK(sum.replaced > 0);
  WARN(sum.kept << " old, " << sum.replaced << " new, beside " << sum.interrupted
                << " unfinished ones");
}

TEST_CASE("a killed program leaves a map with the session that it adds, or without",
          "[examples][long]") {
  std::vector<std::string> files{"map.bag"};
#ifdef TOPOBAG_HAS_SQLITE
  files.emplace_back("map.db");
#endif
  std::mt19937 random(2);
  for (const std::string& file : files) {
    const ScratchFolder first;
    const std::string add = sample_options + "--append --out ";
    REQUIRE(run_program("map --nodes " + sample_map + add + first.path(file)).exit_code == 0);
    const std::string before = content_of(first.path(file));
    const std::string copy = first.write("copy-" + file, before);
    const auto start = Clock::now();
    REQUIRE(run_program("map --nodes " + sample_query + add + copy).exit_code == 0);
    const std::chrono::duration<double> taken = Clock::now() - start;
    std::set<int> found;
    for (unsigned i = 0; i < long_rounds(40); ++i) {
      const ScratchFolder folder;
      const std::string map = folder.write(file, before);
      const std::string command = "map --nodes " + sample_query + add + map;
      // One at once and one long after the end: both are found, however busy the machine is.
      const double share = i == 0   ? 0.0
                           : i == 1 ? 20.0
                                    : std::uniform_real_distribution<>(0.6, 1.1)(random);
      run_and_kill(command, std::chrono::duration_cast<Clock::duration>(share * taken));
      const ProgramRun info = run_program("info --json " + map);
      CAPTURE(file, info.err);
      REQUIRE(info.exit_code == 0);
      const int keyframes = nlohmann::json::parse(info.out).at("keyframes");
      CHECK((keyframes == 67 || keyframes == 67 + 61));
      found.insert(keyframes);
      // And goes on from there.
      if (keyframes == 67) REQUIRE(run_program(command).exit_code == 0);
    }
    CHECK(found.size() == 2);
  }
}
