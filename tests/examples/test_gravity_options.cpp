// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <string>

#include <topobag/bag/snapshot_file.hpp>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"
#include "saved_map.hpp"

namespace {

/// Runs `map` on a sample into a file.
void make_map(const std::string& set, const std::string& path, const std::string& options) {
  const ProgramRun run =
      run_program("map --nodes " + set + sample_options + "--out " + path + ' ' + options);
  CAPTURE(options, run.err);
  REQUIRE(run.exit_code == 0);
}

/// How many of a map's graphs know which way is down.
std::size_t with_gravity(const std::string& path) {
  std::size_t count = 0;
  program::read_saved_map(path).bag.for_each([&](auto, const auto&, const auto& graph) {
    if (graph.gravity()) ++count;
  });
  return count;
}

}  // namespace

TEST_CASE("an axis that is none is refused with a sentence", "[examples][gravity]") {
  const std::string tables =
      "localize --map " + sample_map + " --query " + sample_query + sample_options;
  const std::string form = "; give the axis that points up, such as 0,0,1";
  for (const std::string option : {"--world-up", "--map-world-up"}) {
    CHECK(refusal(tables + option + " 0,0,0") == option + " 0,0,0: it has no direction" + form);
    CHECK(refusal(tables + option + " 0,1") == option + " 0,1: there are not 3 numbers" + form);
    CHECK(refusal(tables + option + " 0,nan,1") ==
          option + " 0,nan,1: 'nan' is not a number" + form);
    CHECK(refusal(tables + option + " inf,0,1") ==
          option + " inf,0,1: 'inf' is not a number" + form);
    CHECK(refusal(tables + option + " up") == option + " up: 'up' is not a number" + form);
  }
  CHECK(refusal(tables + "--world-up 0,0,1 --gravity-noise -1").find("--gravity-noise") == 0);
  CHECK(refusal(tables + "--world-up 0,0,1 --gravity-noise nan").find("--gravity-noise") == 0);
}

TEST_CASE("a map keeps which way is down, and goes on with or without it", "[examples][gravity]") {
#ifdef TOPOBAG_HAS_SQLITE
  const std::string file = GENERATE("map.db", "map.bag");
#else
  const std::string file = "map.bag";
#endif
  const ScratchFolder folder;
  const std::string path = folder.path(file);
  make_map(sample_map, path, "");
  CHECK(with_gravity(path) == 0);
  make_map(sample_query, path, "--append --world-up 0,0,1");
  CHECK(with_gravity(path) == 61);
  program::read_saved_map(path).bag.for_each(
      [&](auto, const topobag::EntryInfo& info, const topobag::TopologyGraph<>& graph) {
        if (!graph.gravity()) return;
        const Eigen::Vector3d down = info.T_world_camera->linear() * graph.gravity()->down;
        CHECK(-down.z() > std::cos(5.0 * 0.0175));
        CHECK(graph.gravity()->deviation <= 0.0175 * 1.05);
      });
  if (file == "map.bag") CHECK(topobag::inspect(path).codec_version == 2);
}

TEST_CASE("without the option a map knows of no vertical, and a noise alone is refused",
          "[examples][gravity][regression]") {
  const ScratchFolder folder;
  make_map(sample_map, folder.path("plain.bag"), "");
  CHECK(with_gravity(folder.path("plain.bag")) == 0);
  CHECK(refusal("map --nodes " + sample_map + " --camera 517.3,516.5,318.6,255.3 " +
                "--gravity-noise 5 --out " + folder.path("noise.bag")) ==
        "--gravity-noise: it does nothing without --world-up; give that, or leave it out");
}

TEST_CASE("a negative axis is an axis", "[examples][gravity]") {
  const ScratchFolder folder;
  make_map(sample_map, folder.path("down.bag"), "--gravity-noise 0 --world-up -1,0,-0.5");
  CHECK(with_gravity(folder.path("down.bag")) == 67);
}

TEST_CASE("a map's world may have another axis", "[examples][gravity]") {
  const std::string options = "--map " + sample_map + " --query " + sample_query +
                              " --camera 517.3,516.5,318.6,255.3 --keyframe-interval 2 "
                              "--world-up 0,0,1 --map-world-up 0,1,0";
  for (const std::string command : {"localize ", "compare "}) {
    const ProgramRun run = run_program(command + options);
    CAPTURE(command, run.err);
    CHECK(run.exit_code == 0);
  }
  CHECK(run_program("explain --frame 0 " + options).exit_code == 0);
}
