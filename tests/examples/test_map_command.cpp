// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/bag/snapshot_file.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

#include "catch.hpp"
#include "child_process.hpp"
#include "keyframe_graphs.hpp"
#include "map_kind.hpp"
#include "run_program.hpp"
#include "sample.hpp"
#include "saved_map.hpp"

using Json = nlohmann::json;

namespace {

/// Without SQLite a snapshot is all there is.
#ifdef TOPOBAG_HAS_SQLITE
const std::vector<std::string> map_files = {"map.db", "map.bag"};
#else
const std::vector<std::string> map_files = {"map.bag"};
#endif

std::string output_of(const std::string& arguments) {
  const ProgramRun run = run_program(arguments);
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty());
  return run.out;
}

Json localized(const std::string& map) {
  Json report = Json::parse(
      output_of("localize --json --map " + map + " --query " + sample_query + sample_options));
  return report;
}

program::KeyframeOptions sample_keyframes() {
  program::KeyframeOptions options;
  options.camera = {517.3, 516.5, 318.6, 255.3, 640, 480};
  options.interval = 0.0;
  return options;
}

/// Saves key frames as `map` does, but without what their cameras saw.
void save_without_views(const std::vector<program::Keyframe>& keyframes, const std::string& path) {
  const topobag::BagOfTopologyGraphs<> bag =
      program::new_entries(topobag::BagOfTopologyGraphs<>(), keyframes);
  topobag::SaveOptions options;
  options.catalog_fingerprint = topobag::fingerprint(topobag::ClassCatalog::coco80());
  options.views = topobag::ViewSection::left_out;
  topobag::save(bag, path, options);
}

}  // namespace

TEST_CASE("a map holds the key frames of its table, rounded", "[examples]") {
  const auto keyframes = program::read_keyframes(sample_map, sample_keyframes());
  for (const std::string& file : map_files) {
    const ScratchFolder folder;
    const std::string path = folder.path(file);
    const std::string said =
        output_of("map --nodes " + sample_map + sample_options + "--out " + path);
    CHECK(said ==
          path + ": 67 key frames of fr1_xyz added to the " + program::map_kind_text(path) + '\n');
    const auto kept = program::read_map(path, {});
    REQUIRE(kept.size() == keyframes.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
      CHECK(kept[i].idx == keyframes[i].idx);
      CHECK(kept[i].timestamp == keyframes[i].timestamp);
      CHECK(kept[i].T_world_camera->isApprox(*keyframes[i].T_world_camera, 1e-12));
      CHECK(topobag::encode(kept[i].graph) == topobag::encode(keyframes[i].graph));
    }
  }
}

TEST_CASE("localize in a saved map answers as in its table", "[examples]") {
  const Json table = localized(sample_map);
  for (const std::string& file : map_files) {
    const ScratchFolder folder;
    const std::string path = folder.path(file);
    output_of("map --nodes " + sample_map + sample_options + "--out " + path);
    const std::string before = content_of(path);
    const Json saved = localized(path);
    CHECK(content_of(path) == before);
    for (const char* key : {"keyframes", "map_keyframes", "queries", "wrong"}) {
      CHECK(saved.at(key) == table.at(key));
    }
    // A graph at the threshold may fall to the other side by its rounding.
    CHECK(std::abs(saved.at("accepted").get<int>() - table.at("accepted").get<int>()) <= 1);
    CHECK(saved.at("median_translation_error_m").get<double>() ==
          Approx(table.at("median_translation_error_m").get<double>()).margin(0.01));
    CHECK(saved.at("median_rotation_error_deg").get<double>() ==
          Approx(table.at("median_rotation_error_deg").get<double>()).margin(0.5));
  }
}

TEST_CASE("several sessions go into one map, and info tells them apart", "[examples]") {
  for (const std::string& file : map_files) {
    const ScratchFolder folder;
    const std::string path = folder.path(file);
    const std::string out = sample_options + "--out " + path;
    output_of("map --nodes " + sample_map + out);
    CHECK(refusal("map --nodes " + sample_query + out) ==
          path + ": it exists; give --append to go on mapping, or another name");
    output_of("map --nodes " + sample_query + out + " --append --session Tuesday");
    const Json info = Json::parse(output_of("info --json " + path));
    CHECK(info.at("keyframes") == 67 + 61);
    CHECK(info.at("file_bytes") == std::filesystem::file_size(path));
    CHECK(info.at("graph_bytes_per_keyframe") < 800.0);  // 54 an object for its looks
    CHECK(info.at("objects").at("tv") > 50);
    const Json& sessions = info.at("sessions");
    REQUIRE(sessions.size() == 2);
    CHECK(sessions.at("0").at("keyframes") == 67);
    CHECK(sessions.at("1").at("keyframes") == 61);
    CHECK(sessions.at("1").at("with_pose") == 61);
    if (file == "map.db") {
      CHECK(sessions.at("0").at("name") == "fr1_xyz");
      CHECK(sessions.at("1").at("name") == "Tuesday");
    }
    CHECK(output_of("info " + path).find("keyframes") != std::string::npos);
  }
}

TEST_CASE("what is no map is refused by name", "[examples]") {
  const ScratchFolder folder;
  const std::string text = folder.write("text.db", "no map");
  CHECK(refusal("info " + text) ==
        text + ": it is no map: neither an SQLite map nor a snapshot of topobag");
  CHECK(refusal("localize --map " + text + " --query " + sample_query + sample_options) ==
        text + ": it is no map: neither an SQLite map nor a snapshot of topobag");
  const std::string path = folder.path("map.bag");
  CHECK(refusal("info " + path) == path + ": the file cannot be opened; check the path");
  output_of("map --nodes " + sample_map + sample_options + "--out " + path);
  const std::string cut = folder.write("cut.bag", content_of(path).substr(0, 1000));
  CHECK(refusal("info " + cut).find(cut + ": entry ") == 0);
  CHECK(refusal("map --nodes " + sample_map + sample_options + "--out " +
                folder.path("none/map.bag")) ==
        "--out " + folder.path("none/map.bag") + ": the folder does not exist; make it first");
}

TEST_CASE("a map without views is localized in and reported, and no drawing is made of it",
          "[examples][report]") {
  const ScratchFolder folder;
  const std::string path = folder.path("map.bag");
  save_without_views(program::read_keyframes(sample_map, sample_keyframes()), path);
  const std::string tables = "--map " + path + " --query " + sample_query + sample_options;
  const Json report = Json::parse(
      output_of("localize --json " + tables + "--report-data " + folder.path("r.json")));
  REQUIRE(report.at("accepted") > 0);
  const Json figures = Json::parse(content_of(folder.path("r.json"))).at("figures");
  CHECK(figures.contains("verdicts"));
  CHECK_FALSE(figures.contains("match-best"));
  const std::string sentence = path + ": its graphs hold no views, which a drawing needs";
  CHECK(refusal("localize " + tables + "--svg " + folder.path("m.svg")) == sentence);
  const int frame = report.at("matches").at(0).at("query_idx");
  CHECK(refusal("explain " + tables + "--svg " + folder.path("m.svg") + " --frame " +
                std::to_string(frame)) == sentence);
}

TEST_CASE("a map without a key frame is refused by name", "[examples]") {
  const ScratchFolder folder;
  const std::string path = folder.path("empty.bag");
  save_without_views({}, path);
  CHECK(refusal("localize --map " + path + " --query " + sample_query + sample_options) ==
        path + ": the map holds no key frame");
  CHECK(Json::parse(output_of("info --json " + path)).at("keyframes") == 0);
}

TEST_CASE("two commands that append to one map at a time both get in", "[examples]") {
  for (const std::string& file : map_files) {
    const ScratchFolder folder;
    const std::string path = folder.path(file);
    const auto append = [&](const std::string& table) {
      return [=](const auto&) {
        if (run_program("map --nodes " + table + sample_options + "--append --out " + path)
                .exit_code != 0) {
          throw std::runtime_error("not added");
        }
      };
    };
    ChildProcess one(append(sample_map)), other(append(sample_query));
    CHECK(one.wait());
    CHECK(other.wait());
    const Json info = Json::parse(output_of("info --json " + path));
    CHECK(info.at("keyframes") == 67 + 61);
    CHECK(info.at("sessions").size() == 2);
  }
}

TEST_CASE("a map is what its content says, whatever its name", "[examples]") {
  for (const std::string& file : map_files) {
    const ScratchFolder folder;
    output_of("map --nodes " + sample_map + sample_options + "--out " + folder.path(file));
    const std::string other = folder.path(file == "map.bag" ? "other.db" : "other.bag");
    std::filesystem::rename(folder.path(file), other);
    output_of("map --nodes " + sample_query + sample_options + "--append --out " + other);
    CHECK(Json::parse(output_of("info --json " + other)).at("keyframes") == 67 + 61);
  }
}

TEST_CASE("a command that is refused leaves the map as it was, or none", "[examples]") {
  for (const std::string& file : map_files) {
    const ScratchFolder folder;
    const std::string path = folder.path(file);
    const std::string out = sample_options + "--out " + path;
    CHECK(refusal("map --nodes " + sample_map + out +
                  " --session 'K\xFC"
                  "che'") == "--session is not UTF-8");
    program::NodeTable negative = program::read_node_table(sample_map);
    negative.frames.front().idx = -1;
    program::write_node_table(folder.path("t"), negative);
    CHECK(refusal("map --nodes " + folder.path("t") + out).find("frame idx -1 is negative") == 0);
    CHECK_FALSE(std::filesystem::exists(path));
    output_of("map --nodes " + sample_map + out);
    const std::string before = content_of(path);
    CHECK(refusal("map --append --nodes " + sample_map + out) ==
          path +
              ": the map holds these key frames already, as session 0: mapped twice, a place is "
              "found by itself");
    CHECK(content_of(path) == before);
    const auto files = std::filesystem::directory_iterator(folder.path());
    CHECK(std::distance(begin(files), end(files)) == 3);  // the map and the table
  }
}

TEST_CASE("a file whose name is no UTF-8 is told of in JSON that is", "[examples]") {
  const ScratchFolder folder;
  const std::string path = folder.path("m\xFC.bag");
  output_of("map --nodes " + sample_map + sample_options + "--out '" + path + "'");
  CHECK(Json::parse(output_of("info --json '" + path + "'")).at("map") ==
        folder.path("m\xEF\xBF\xBD.bag"));
}
