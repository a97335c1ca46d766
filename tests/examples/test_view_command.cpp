// SPDX-License-Identifier: MIT
#include <cstddef>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "examples/report/page_text.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

/// The page that `view` writes.
std::string viewed(const std::string& arguments) {
  const ScratchFolder folder;
  const ProgramRun run = run_program("view " + arguments + " --out " + folder.path("map.html"));
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  return program::read_file(folder.path("map.html"));
}

nlohmann::json shown_in(const std::string& page) {
  const std::string start = "id=\"map-data\">";
  const std::size_t from = page.find(start) + start.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

/// That every list has its length, and every number of an object or key frame is one.
void check_consistent(const nlohmann::json& shown) {
  const auto& objects = shown.at("objects");
  const auto& keyframes = shown.at("keyframes");
  const std::size_t object_count = objects.at("class").size();
  const std::size_t keyframe_count = keyframes.at("name").size();
  CHECK(objects.at("position").size() == 3 * object_count);
  CHECK(objects.at("size").size() == 2 * object_count);
  CHECK(objects.at("sight").size() == 3 * object_count);
  for (const auto& label : objects.at("class")) CHECK(label < shown.at("classes").size());
  for (std::size_t i = 0; i < object_count; ++i) {
    CHECK(objects.at("first")[i] <= objects.at("last")[i]);
    CHECK(objects.at("last")[i] < keyframe_count);
    CHECK(objects.at("keyframes")[i] >= 1);
  }
  CHECK(keyframes.at("time").size() == keyframe_count);
  CHECK(keyframes.at("position").size() == 3 * keyframe_count);
  CHECK(keyframes.at("rotation").size() == 4 * keyframe_count);
  for (std::size_t i = 0; i < keyframe_count; ++i) {
    for (const auto& object : keyframes.at("objects")[i]) CHECK(object < object_count);
    CHECK(keyframes.at("edges")[i].size() % 2 == 0);
    for (const auto& object : keyframes.at("edges")[i]) CHECK(object < object_count);
  }
  for (const auto& match : shown.at("matches")) {
    CHECK(match.at("candidate") < keyframe_count);
    if (!match.at("query").is_null()) CHECK(match.at("query") < keyframe_count);
    CHECK(match.at("matched").size() >= 3);
    CHECK(match.at("sentence").get<std::string>().find("Key frame idx ") == 0);
    CHECK(match.at("stages").size() >= 4);
  }
}

}  // namespace

TEST_CASE("view writes one page that needs no other and holds the map", "[examples]") {
  const std::string page = viewed(sample_map + sample_options);
  CHECK(page.find("<!DOCTYPE html>") == 0);
  CHECK(times(page, "<script") == 2);
  CHECK(times(page, "</script>") == 2);
  CHECK(times(page, "<canvas ") == 1);
  CHECK(references(page).empty());
  const nlohmann::json shown = shown_in(page);
  check_consistent(shown);
  CHECK(shown.at("title") == "fr1_xyz");
  CHECK(shown.at("up") == nlohmann::json{0.0, 0.0, 1.0});
  CHECK(shown.at("keyframes").at("name").size() == 67);
  CHECK(shown.at("objects").at("class").size() >= 10);
  CHECK(shown.at("objects").at("class").size() < 67);
  CHECK(shown.at("matches").empty());
}

TEST_CASE("view shows what loops and localize find", "[examples]") {
  const auto accepted = [](const std::string& arguments) {
    const ProgramRun run = run_program(arguments + sample_options + "--json");
    return nlohmann::json::parse(run.out).at("matches");
  };
  const nlohmann::json loops =
      shown_in(viewed(sample_map + sample_options + "--loops --min-gap 5"));
  check_consistent(loops);
  const nlohmann::json found = accepted("loops --min-gap 5 --nodes " + sample_map);
  REQUIRE(loops.at("matches").size() == found.size());
  REQUIRE(found.size() > 0);
  CHECK(loops.at("matches")[0].at("name") ==
        "idx " + std::to_string(found[0].at("query_idx").get<int>()));
  CHECK(loops.at("matches")[0].at("verdict") == found[0].at("verdict"));
  CHECK_FALSE(loops.at("matches")[0].at("query").is_null());

  const nlohmann::json looked_up =
      shown_in(viewed(sample_map + sample_options + "--query " + sample_query));
  check_consistent(looked_up);
  const nlohmann::json localized =
      accepted("localize --map " + sample_map + " --query " + sample_query);
  CHECK(looked_up.at("matches").size() == localized.size());
  CHECK(looked_up.at("matches")[0].at("query").is_null());
}

TEST_CASE("a saved map is shown as its table is, and brings its camera", "[examples]") {
  const ScratchFolder folder;
  const std::string map = folder.path("fr1_xyz");
  REQUIRE(run_program("map --nodes " + sample_map + sample_options + "--out " + map).exit_code ==
          0);
  const nlohmann::json saved = shown_in(viewed(map));
  const nlohmann::json table = shown_in(viewed(sample_map + sample_options));
  CHECK(saved.at("objects").at("class").size() == table.at("objects").at("class").size());
  CHECK(saved.at("keyframes").at("position") == table.at("keyframes").at("position"));
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(saved.at("image")[i].get<double>() ==
          Approx(table.at("image")[i].get<double>()).margin(1e-3));
  }
}

TEST_CASE("view refuses what it cannot show, and leaves a page that is there", "[examples]") {
  const ScratchFolder folder;
  const std::string page = folder.write("map.html", "as it was");
  const std::string out = " --out " + page;
  CHECK(refusal("view nowhere" + sample_options + out) ==
        "nowhere: there is no such file, and no table of this name; check the path");
  CHECK(refusal("view " + sample_map + out) ==
        "--camera: a table does not tell of its camera; give its intrinsics");
  CHECK(refusal("view" + out) == "map is required; see topobag view --help");
  CHECK(refusal("view " + sample_map + sample_options) ==
        "--out is required; see topobag view --help");
  CHECK(refusal("view " + sample_map + sample_options + "--loops --query " + sample_query + out)
            .find("excludes --") != std::string::npos);
  const std::string empty = folder.write("empty.bag", "");
  CHECK(refusal("view " + empty + out) ==
        empty + ": it is no map: neither an SQLite map nor a snapshot of topobag");
  const std::string poseless = folder.path("poseless");
  folder.write("poseless.frames.csv", "idx,frame,timestamp\n0,a,0\n");
  folder.write("poseless.nodes.csv",
               "idx,class,conf,u,v,w,h,z\n0,cup,1,100,100,20,20,2\n0,tv,1,300,100,20,20,2\n"
               "0,book,1,200,300,20,20,2\n");
  CHECK(refusal("view " + poseless + sample_options + "--window 0" + out) ==
        poseless +
            ": none of the 1 key frames has a pose, so there is no place to draw them at; give "
            "--trajectory");
  CHECK(program::read_file(page) == "as it was");
  refusal("view " + sample_map + sample_options + "--out " + folder.path("no/where.html"));
  CHECK(run_program("view " + sample_map + sample_options + out).exit_code == 0);
  CHECK(program::read_file(page).size() > 10000);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path(""))) {
    files += entry.is_regular_file() ? 1U : 0U;
  }
  CHECK(files == 4);
}
