// SPDX-License-Identifier: MIT
// The program is killed at any moment: each of its outputs is then the old file or the new one.
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "child_process.hpp"
#include "long_rounds.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Whole = std::function<bool(const std::string&)>;

/// What a file holds when it is whole: a text that says nothing of how long things took is compared
/// with the one of a run that was not killed.
struct Output {
  std::string file;
  Whole is_whole{};  ///< unset: it is the text of the other run
};

/// A command that writes files beside `arguments`, where FOLDER stands for their folder.
struct Writer {
  std::string arguments;
  std::vector<Output> outputs;
};

std::string in_folder(std::string arguments, const std::string& folder) {
  for (std::size_t at; (at = arguments.find("FOLDER")) != std::string::npos;) {
    arguments.replace(at, 6, folder);
  }
  return arguments;
}

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

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
bool is_page(const std::string& text) {
  return text.find("<!DOCTYPE html>") == 0 && ends_with(text, "</html>\n");
}
bool is_json(const std::string& text) { return nlohmann::json::accept(text); }
bool is_drawing(const std::string& text) {
  return text.find("<svg ") == 0 && ends_with(text, "</svg>\n");
}

/// How often files were found old, new, and beside an unfinished one.
struct Findings {
  std::size_t kept = 0, replaced = 0, interrupted = 0;
};

/// Kills the writer again and again over files that say "old".
Findings kill(const Writer& writer, unsigned kills, std::mt19937& random) {
  const ScratchFolder whole;
  const auto start = Clock::now();
  const ProgramRun run = run_program(in_folder(writer.arguments, whole.path()));
  const std::chrono::duration<double> taken = Clock::now() - start;
  CAPTURE(writer.arguments, run.err);
  REQUIRE(run.exit_code == 0);
  Findings findings;
  for (unsigned i = 0; i < kills; ++i) {
    const ScratchFolder folder;
    for (const Output& output : writer.outputs) folder.write(output.file, "old");
    // Most of the time nothing is written yet: rather late than early.
    const double share = std::uniform_real_distribution<>(i % 4 == 0 ? 0.0 : 0.8, 1.1)(random);
    run_and_kill(in_folder(writer.arguments, folder.path()),
                 std::chrono::duration_cast<Clock::duration>(share * taken));
    for (const Output& output : writer.outputs) {
      const std::string found = content_of(folder.path(output.file));
      const bool is_new =
          output.is_whole ? output.is_whole(found) : found == content_of(whole.path(output.file));
      CAPTURE(output.file, found.size());
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

/// Three images of 64 x 48 px, all of them 2 m away, each with three boxes.
void write_images(const ScratchFolder& folder) {
  const std::string size = "64 48\n";
  std::string depth = "P5\n" + size + "65535\n", list, boxes = "[";
  for (int i = 0; i < 64 * 48; ++i) depth += std::string("\x27\x10");
  for (int image = 0; image < 3; ++image) {
    const std::string name = std::to_string(image);
    folder.write(name + ".ppm", "P6\n" + size + "255\n" + std::string(3 * 64 * 48, '\0'));
    folder.write(name + ".pgm", depth);
    list += name + ".0 " + name + ".ppm " + name + ".0 " + name + ".pgm\n";
    for (int box = 0; box < 3; ++box) {
      boxes += std::string(boxes.size() > 1 ? "," : "") + R"({"image_id": ")" + name +
               R"(", "category_id": 72, "score": 0.9, "bbox": [)" + std::to_string(18 * box) +
               ", 5, 15, 15]}";
    }
  }
  folder.write("associations.txt", list);
  folder.write("boxes.json", boxes + "]");
}

const std::string killed_tables =
    " --map " + sample_map + " --query " + sample_query + sample_options;

}  // namespace

TEST_CASE("a killed program leaves tables, reports and lists whole", "[examples][long]") {
  const ScratchFolder inputs;
  write_images(inputs);
  const std::string poses = inputs.write(
      "poses.txt", "0 0 0 0 0 0 0 1\n10 0.1 0 0 0 0 0 1\n20 9 0 0 0 0 0 1\n30 9.1 0 0 0 0 0 1\n");
  const std::string scores =
      inputs.write("scores.csv", "nan,.9,.8,.1\n.9,nan,.2,.1\n.8,.2,nan,.7\n.1,.1,.6,nan\n");
  const std::vector<Writer> writers{
      {"localize" + killed_tables +
           "--svg FOLDER/m.svg --pairs FOLDER/p.csv --report FOLDER/r.html --report-data "
           "FOLDER/r.json",
       {{"m.svg", is_drawing}, {"p.csv"}, {"r.html", is_page}, {"r.json", is_json}}},
      {"localize" + killed_tables +
           "--min-confidence 0.5 --window 0 --calibrate --save-calibration FOLDER/c.txt",
       {{"c.txt"}}},
      {"explain --frame 30" + killed_tables + "--svg FOLDER/e.svg", {{"e.svg"}}},
      {"evaluate --scores " + scores + " --poses " + poses +
           " --protocol distance=1 --curve FOLDER/c.csv --ranks FOLDER/k.csv --report "
           "FOLDER/r.html --report-data FOLDER/r.json",
       {{"c.csv"}, {"k.csv"}, {"r.html"}, {"r.json"}}},
      {"trajectory --groundtruth " + poses + " --estimate " + poses + " --errors FOLDER/e.csv",
       {{"e.csv"}}},
      {"nodes --images " + inputs.path() + " --boxes " + inputs.path("boxes.json") +
           " --camera 50,50,31.5,23.5 --out FOLDER/set",
       {{"set.frames.csv"}, {"set.nodes.csv"}}}};
  std::mt19937 random(1);
  Findings sum;
  for (const Writer& writer : writers) {
    if (run_program(writer.arguments).err.find("was not built") != std::string::npos) continue;
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
      const double share = std::uniform_real_distribution<>(0.6, 1.1)(random);
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
