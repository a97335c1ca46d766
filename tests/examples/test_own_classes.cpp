// SPDX-License-Identifier: MIT
#include <string>

#include "catch.hpp"
#include "own_classes.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

/// Takes a map's and a query's table through every command that reads one.
void require_every_command(const OwnClasses& own, const std::string& map,
                           const std::string& query) {
  const std::string tables = "--map " + map + " --query " + query + own.options;
  const auto found = own_json("localize " + tables);
  CHECK(found.at("accepted") > 0);
  CHECK(found.at("wrong") == 0);
  REQUIRE(found.at("matches").size() > 0);
  for (const auto& [name, count] : found.at("matches")[0].at("matched").items()) {
    CHECK(own.classes.catalog.dynamics(own.classes.catalog.at(name)) != topobag::Dynamics::high);
  }
  const std::string frame = std::to_string(found.at("matches")[0].at("query_idx").get<int>());
  const auto told = own_json("explain --frame " + frame + ' ' + tables);
  CHECK(told.at("candidates")[0].at("verdict") == "accepted");
  const std::string svg = own.folder.path("match.svg");
  CHECK(run_program("explain --svg " + svg + " --frame " + frame + ' ' + tables).exit_code == 0);
  CHECK(content_of(svg).find("rack") != std::string::npos);
  CHECK(own_json("loops --min-gap 10 --nodes " + query + own.options).at("accepted") > 0);
  CHECK(run_program("localize --verbose --calibrate " + tables).exit_code == 0);
  CHECK(own_json("compare " + tables).at("methods").size() > 1);
  CHECK(own_json("similarity --frames 0,3 --nodes " + query + own.options).at("frames").size() ==
        2);
  for (const std::string& name : own_maps) {
    const ScratchFolder folder;
    const std::string file = folder.path(name);
    REQUIRE(run_program("map --nodes " + map + own.options + "--out " + file).exit_code == 0);
    const auto objects = own_json("info " + file + own.option + ' ').at("objects");
    CHECK(objects.size() == 17);  // all but what moves by itself
    CHECK_FALSE(objects.contains("forklift"));
    const auto localized = own_json("localize --map " + file + " --query " + query + own.options);
    CHECK(localized.at("accepted") > 0);
  }
}

/// Makes a table of images and another detector's boxes; false where the program cannot.
bool make_own_table(const OwnClasses& own, const std::string& images, const std::string& boxes,
                    const std::string& set) {
  const ProgramRun run = run_program("nodes --depth-scale 1000 --images " + images + " --boxes " +
                                     boxes + " --out " + set + own.options);
  if (run.err.find("was not built") != std::string::npos) return false;  // it needs OpenCV
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  return true;
}

}  // namespace

TEST_CASE("classes of one's own go through every command from a table", "[examples]") {
  const OwnClasses own;
  require_every_command(own, own.first.write_table(own.folder, "map"),
                        own.second.write_table(own.folder, "query"));
}

TEST_CASE("classes of one's own go through every command from COCO's JSON", "[examples]") {
  const OwnClasses own;
  const ScratchFolder map, query;
  own.first.write_images(map);
  own.second.write_images(query);
  const std::string map_set = own.folder.path("map"), query_set = own.folder.path("query");
  const std::string boxes = own.folder.write("first.json", own.first.coco_results());
  if (!make_own_table(own, map.path(), boxes, map_set)) return;
  make_own_table(own, query.path(), own.folder.write("second.json", own.second.coco_results()),
                 query_set);
  require_every_command(own, map_set, query_set);
}

TEST_CASE("classes of one's own go through every command from YOLO's text", "[examples]") {
  const OwnClasses own;
  const ScratchFolder map, query, map_boxes, query_boxes;
  own.first.write_images(map);
  own.second.write_images(query);
  own.first.write_yolo(map_boxes);
  own.second.write_yolo(query_boxes);
  const std::string map_set = own.folder.path("map"), query_set = own.folder.path("query");
  if (!make_own_table(own, map.path(), map_boxes.path(), map_set)) return;
  make_own_table(own, query.path(), query_boxes.path(), query_set);
  require_every_command(own, map_set, query_set);
}

TEST_CASE("a map goes with the classes that it was made with", "[examples]") {
  const OwnClasses own;
  const std::string table = own.first.write_table(own.folder, "map");
  const std::string renamed = own.folder.write(
      "renamed.txt", "truck" + warehouse_classes.substr(warehouse_classes.find(", high")));
  const std::string other = "its class numbers mean other names than yours";
  for (const std::string& name : own_maps) {
    const std::string file = own.folder.path(name);
    REQUIRE(run_program("map --nodes " + table + own.options + "--out " + file).exit_code == 0);
    const std::string before = content_of(file);
    CHECK(refusal("info " + file + " --classes " + renamed).find(file + ": " + other) == 0);
    // Without `--classes` the map's own hold, of which the sample's objects are none.
    CHECK(refusal("localize --map " + file + " --query " + sample_query + sample_options)
              .find(sample_query + ".nodes.csv:2: unknown class '") == 0);
    CHECK(refusal("map --append --nodes " + sample_map + sample_options + "--out " + file)
              .find(sample_map + ".nodes.csv:2: unknown class '") == 0);
    CHECK(content_of(file) == before);
  }
}

TEST_CASE("what the classes do not hold is refused", "[examples]") {
  const OwnClasses own;
  const std::string table = own.first.write_table(own.folder, "map");
  CHECK(refusal("map --nodes " + table + warehouse_camera + "--out " + own.folder.path("m.bag"))
            .find(table + ".nodes.csv:2: unknown class '") == 0);
  const std::string gone = own.folder.path("gone.txt");
  CHECK(refusal("info m.bag --classes " + gone).find(gone + ":") == 0);
}
