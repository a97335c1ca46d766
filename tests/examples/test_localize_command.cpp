// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include <topobag/sensing/color_descriptor.hpp>

#include "catch.hpp"
#include "node_table.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

using Json = nlohmann::json;

Json localize(const std::string& options) {
  const ProgramRun run = run_program("localize --map " + sample_map + " --query " + sample_query +
                                     sample_options + " --json " + options);
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty());
  return Json::parse(run.out);
}

void check_counts(const Json& report) {
  const auto count = [&](const char* key) { return report.at(key).get<std::size_t>(); };
  CHECK(count("keyframes") >= count("queries"));
  CHECK(count("queries") >= count("accepted"));
  CHECK(count("accepted") ==
        count("correct") + count("imprecise") + count("wrong") + count("unscored"));
  CHECK(report.at("matches").size() == count("accepted"));
}

/// A copy of the sample's query with one line of one of its files replaced.
struct EditedSample {
  EditedSample(const std::string& file, std::size_t line, const std::string& text) {
    for (const std::string ending : {".frames.csv", ".nodes.csv"}) {
      std::string content = program::read_file(sample_query + ending);
      if (ending == file) {
        std::size_t begin = 0;
        for (std::size_t i = 1; i < line; ++i) begin = content.find('\n', begin) + 1;
        content.replace(begin, content.find('\n', begin) - begin, text);
      }
      folder.write("s" + ending, content);
    }
  }

  /// What the program says of it, without the folder.
  std::string refusal() const {
    const std::string said =
        ::refusal("localize --map " + sample_map + " --query " + folder.path("s") + sample_options);
    return said.substr(0, folder.path("").size()) == folder.path("")
               ? said.substr(folder.path("").size())
               : said;
  }

  ScratchFolder folder;
};

}  // namespace

TEST_CASE("localize reports in JSON", "[examples]") {
  const Json report = localize("");
  CHECK(report.at("keyframes") == 61);
  CHECK(report.at("map_keyframes") == 67);
  check_counts(report);
  CHECK(report.at("wrong") == 0);
  CHECK(report.at("correct") > 20);
  CHECK(report.at("median_translation_error_m") < 0.3);
  CHECK(report.at("median_rotation_error_deg") < 15.0);
  const Json& ms = report.at("query_ms");
  CHECK(ms.at("median") > 0.0);
  CHECK(ms.at("percentile_95") >= ms.at("median"));
  CHECK(ms.at("worst") >= ms.at("percentile_95"));
  CHECK(ms.at("worst") >= ms.at("mean"));
  for (const Json& match : report.at("matches")) {
    CHECK(match.at("pose_candidate_query").size() == 7);
    CHECK(match.at("matched").size() >= 1);
    CHECK(match.at("translation_error_m") < 1.0);
  }
}

TEST_CASE("localize works on single frames", "[examples]") {
  const Json report = localize("--window 0");
  check_counts(report);
  CHECK(report.at("wrong") == 0);
  CHECK(report.at("accepted") > 0);
}

TEST_CASE("localize finds the scale where it is not known", "[examples]") {
  const Json known = localize(""), report = localize("--unknown-scale");
  check_counts(report);
  CHECK(report.at("wrong") == 0);
  const auto accepted = report.at("accepted").get<double>();
  CHECK(accepted >= 0.8 * known.at("accepted").get<double>());
  for (const Json& match : report.at("matches")) {
    const auto scale = match.at("scale").get<double>();
    CHECK(std::abs(scale - 1.0) < 4.0 * match.at("scale_deviation").get<double>());
  }
  for (const Json& match : known.at("matches")) CHECK_FALSE(match.contains("scale"));
}

TEST_CASE("between different places all that is accepted is wrong", "[examples]") {
  const Json report = localize("--different-places");
  check_counts(report);
  CHECK(report.at("accepted") > 0);
  CHECK(report.at("wrong") == report.at("accepted"));
  CHECK(report.at("median_translation_error_m").is_null());
}

TEST_CASE("the scoring's limits are options", "[examples]") {
  CHECK(localize("--correct-translation 0 --correct-rotation 0").at("correct") == 0);
  const Json strict = localize(
      "--correct-translation 0 --wrong-translation 0 --correct-rotation 0 --wrong-rotation 0");
  CHECK(strict.at("wrong") == strict.at("accepted"));
  CHECK(refusal("localize --map a --query b --camera 500,500,320,240 --wrong-translation 0.1") ==
        "--wrong-translation: wrong begins at 0.1, below where correct ends, at 0.3; give "
        "--wrong-translation and --correct-translation in their order");
}

TEST_CASE("stress costs matches, and a seed repeats it", "[examples]") {
  const Json calm = localize(""), first = localize("--depth-noise 0.02 --drop 0.3 --flip 0.1");
  CHECK(first.at("accepted") < calm.at("accepted"));
  CHECK(localize("--depth-noise 0.02 --drop 0.3 --flip 0.1 --seed 1").at("matches") ==
        first.at("matches"));
  CHECK(localize("--depth-noise 0.02 --drop 0.3 --flip 0.1 --seed 2").at("matches") !=
        first.at("matches"));
  CHECK(refusal("localize --map " + sample_map + " --query " + sample_query + sample_options +
                "--drop 1")
            .find("fr1_xyz.nodes.csv: none of the 67 key frames has three objects") !=
        std::string::npos);
}

TEST_CASE("the map may have a camera of its own", "[examples]") {
  const Json same = localize("--map-camera 517.3,516.5,318.6,255.3,640,480");
  CHECK(same.at("accepted") == localize("").at("accepted"));
  const Json other = localize("--map-camera 1000,1000,318.6,255.3");
  CHECK(other.at("accepted") < same.at("accepted"));
}

TEST_CASE("localize tells a reader what became of each key frame", "[examples]") {
  const ProgramRun run = run_program("localize --map " + sample_map + " --query " + sample_query +
                                     sample_options + " --verbose");
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("67 key frames") != std::string::npos);
  CHECK(run.out.find("accepted, map idx ") != std::string::npos);
  CHECK(run.out.find("no usable graph") != std::string::npos);
  CHECK(std::count(run.out.begin(), run.out.end(), '\n') > 61);
}

TEST_CASE("localize draws the best match", "[examples]") {
  const ScratchFolder folder;
  const std::string file = folder.path("match.svg");
  const Json report = localize("--svg " + file);
  const std::string drawing = program::read_file(file);
  const auto occurrences = [&](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = drawing.find(text); at != std::string::npos;
         at = drawing.find(text, at + 1)) {
      ++count;
    }
    return count;
  };
  CHECK(drawing.find("<svg ") == 0);
  CHECK(drawing.find("nan") == std::string::npos);
  CHECK(occurrences("class=\"match\"") >= 3);
  CHECK(occurrences("<circle") == occurrences("class=\"label\""));
  const Json& matches = report.at("matches");
  const Json& best =
      *std::max_element(matches.begin(), matches.end(),
                        [](const Json& a, const Json& b) { return a.at("score") < b.at("score"); });
  CHECK(drawing.find("query, idx " + std::to_string(best.at("query_idx").get<int>())) !=
        std::string::npos);
}

TEST_CASE("bad input ends localize with one line that names file and line", "[examples]") {
  const std::string no_looks(1 + topobag::ColorDescriptor::kind.length(), ',');
  CHECK(EditedSample(".nodes.csv", 3, "0,63,laptop,0.5,nan,170,210,200,1.1" + no_looks).refusal() ==
        "s.nodes.csv:3: column 'u' holds 'nan', which is not a finite number");
  CHECK(EditedSample(".nodes.csv", 4, "0,63,lap,0.5,320,170,210,200,1.1" + no_looks)
            .refusal()
            .find("s.nodes.csv:4: unknown class 'lap'") == 0);
  CHECK(EditedSample(".nodes.csv", 1, "idx,number,kind,conf,u,v,w,h,z")
            .refusal()
            .find("s.nodes.csv:1: there is no column 'class'") == 0);
  CHECK(EditedSample(".frames.csv", 5, "3,a.png,1305031230.7,,,,,,,").refusal() ==
        "s.frames.csv: frame idx 3 has no pose, which a window needs; give --window 0");
  CHECK(EditedSample(".frames.csv", 5, "3,a.png,1305031230.7,1e9,0,0,0,0,0,1").refusal() ==
        "s.frames.csv: the pose of frame idx 3 is 1e+09 m away from that of the key frame before; "
        "check tx, ty and tz of both");
  CHECK(refusal("localize --map nowhere --query nowhere --camera 500,500,320,240") ==
        "nowhere: there is no such file, and no table of this name; check the path");
  const ScratchFolder folder;
  folder.write("s.frames.csv", "idx,frame,timestamp\n");
  folder.write("s.nodes.csv", "idx,class,conf,u,v,w,h,z\n");
  CHECK(refusal("localize --map " + folder.path("s") + " --query s --camera 500,500,320,240") ==
        folder.path("s.frames.csv") + ": the table holds no frame");
}

TEST_CASE("bad options end localize with one line", "[examples]") {
  const std::string sets = "localize --map a --query b --camera 500,500,320,240 ";
  CHECK(refusal(sets + "--window nan").find("'nan' is not a number in [0, inf)") !=
        std::string::npos);
  CHECK(refusal(sets + "--keyframe-interval -1").find("--keyframe-interval") != std::string::npos);
  CHECK(refusal(sets + "--min-confidence 1.5").find("[0, 1]") != std::string::npos);
  refusal(sets + "--depth-noise -1");
  refusal(sets + "--drop 1.1");
  refusal(sets + "--flip nan");
  refusal(sets + "--seed -1");
  CHECK(refusal(sets + "--image-size 640") ==
        "--image-size 640: there are not 2 numbers; give width,height");
  CHECK(refusal(sets + "--map-camera 5,5").find("--map-camera 5,5: there are not 4 or 6 numbers") ==
        0);
}

TEST_CASE("tables without poses are localized from single frames, unscored", "[examples]") {
  const ScratchFolder folder;
  program::NodeTable table = program::read_node_table(sample_query);
  for (program::FrameRow& frame : table.frames) frame.T_world_camera.reset();
  program::write_node_table(folder.path("s"), table);
  const ProgramRun run = run_program("localize --map " + sample_map + " --query " +
                                     folder.path("s") + sample_options + "--window 0 --json");
  REQUIRE(run.exit_code == 0);
  const Json report = Json::parse(run.out);
  check_counts(report);
  CHECK(report.at("unscored") == report.at("accepted"));
  CHECK(report.at("accepted") > 0);
}
