// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <vector>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

const std::string used_camera = " --camera 517.3,516.5,318.6,255.3 --window 0 ";

}  // namespace

TEST_CASE("an option of a map of objects is refused where there is none",
          "[examples][regression]") {
  const ScratchFolder folder;
  const std::string words = folder.write("words.txt", "mug\ntome\n");
  const std::string relation =
      folder.write("r.json", R"({"scale": 1.1, "deviation": 0.05, "classes": []})");
  const std::string saved = folder.path("map.bag");
  REQUIRE(run_program("map --nodes " + sample_map + used_camera + "--out " + saved).exit_code == 0);
  const std::string localize = "localize --query " + sample_query + used_camera + "--map ";
  for (const std::string& option :
       std::vector<std::string>{"--map-relation " + relation, "--map-words " + words,
                                "--object-scale 2", "--object-deviation 0.1"}) {
    const std::string start = option.substr(0, option.find(' ')) + ": it is for a map of objects; ";
    CHECK(refusal(localize + sample_map + ' ' + option) == start + sample_map + " is a table");
    CHECK(refusal(localize + saved + ' ' + option) == start + saved + " was not made of one");
    CHECK(refusal("loops --nodes " + sample_map + used_camera + option) ==
          start + sample_map + " is a table");
    CHECK(refusal("map --nodes " + sample_map + used_camera + "--out " + folder.path("m.bag ") +
                  option) == start + sample_map + " is a table");
  }
}

TEST_CASE("an option that does nothing without another is refused", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string tables = "localize --map " + sample_map + " --query " + sample_query;
  const std::string without = ": it does nothing without ";
  const std::string give = "; give that, or leave it out";
  CHECK(refusal(tables + used_camera + "--gravity-noise 2") ==
        "--gravity-noise" + without + "--world-up or --map-world-up" + give);
  CHECK(refusal(tables + used_camera + "--protocol distance=2") ==
        "--protocol" + without + "--report or --report-data or --pairs" + give);
  CHECK(refusal("view " + sample_map + used_camera + "--min-gap 5 --out " +
                folder.path("v.html")) == "--min-gap" + without + "--loops" + give);
  CHECK(refusal("map --nodes " + sample_map + used_camera + "--gravity-noise 2 --out " +
                folder.path("m.bag")) == "--gravity-noise" + without + "--world-up" + give);
}

TEST_CASE("relate takes nothing that it learns", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string relate = "relate --map " + folder.write("m.json", "{\"nodes\": []}") +
                             " --query " + sample_query + used_camera + "--out " +
                             folder.path("r.json ");
  for (const std::string option : {"--object-scale", "--object-deviation"}) {
    CHECK(refusal(relate + option + " 0.1") == option + ": it is what relate learns; leave it out");
  }
}

TEST_CASE("a saved map takes no option that makes key frames", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string saved = folder.path("map.bag");
  REQUIRE(run_program("map --nodes " + sample_map + used_camera + "--out " + saved).exit_code == 0);
  for (const std::string option :
       {"--window 1", "--keyframe-interval 2", "--trajectory poses.txt", "--drop 0.5"}) {
    CHECK(refusal("view " + saved + " --out " + folder.path("v.html ") + option) ==
          option.substr(0, option.find(' ')) + ": it is for a table, and " + saved +
              " is a saved map; leave it out, or make the map anew with it");
  }
  const ProgramRun query = run_program("view " + saved + " --query " + sample_query + used_camera +
                                       "--out " + folder.path("v.html"));
  CAPTURE(query.err);
  CHECK(query.exit_code == 0);  // there they are the query's
  CHECK(query.out.find(" key frames that could be looked up\n") != std::string::npos);
}

TEST_CASE("what draws nothing needs no seed", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string told = "--seed: it does nothing without --depth-noise or --drop or --flip or ";
  const std::string two_sets = " --map " + sample_map + " --query " + sample_query + used_camera;
  for (const std::string& command :
       {"localize" + two_sets, "explain --frame 3" + two_sets, "compare" + two_sets}) {
    CHECK(refusal(command + "--seed 5") ==
          told + "--world-up or --map-world-up; give that, or leave it out");
  }
  CHECK(refusal("loops --nodes " + sample_map + used_camera + "--seed 5") ==
        told + "--world-up; give that, or leave it out");
  const std::string scores =
      "evaluate --poses " + sample_map + " --scores " + folder.write("s.csv", "0,1\n1,0\n");
  for (const std::string option : {"--level 0.9", "--seed 4"}) {
    CHECK(refusal(scores + ' ' + option) == option.substr(0, option.find(' ')) +
                                                ": it does nothing without --bootstrap or "
                                                "--against; give that, or leave it out");
  }
}

TEST_CASE("explain refuses what localize does", "[examples][regression]") {
  const std::string explain =
      "explain --frame 3 --map " + sample_map + " --query " + sample_query + used_camera;
  CHECK(refusal(explain + "--object-scale 2") ==
        "--object-scale: it is for a map of objects; " + sample_map + " is a table");
  CHECK(refusal(explain + "--gravity-noise 2").find("--gravity-noise: it does nothing") == 0);
}

TEST_CASE("which way is up says nothing of a table without poses", "[examples][regression]") {
  const ScratchFolder folder;
  std::string frames = "idx,frame,timestamp\n";
  for (int i = 0; i < 61; ++i) {
    frames += std::to_string(i) + ",a.png," + std::to_string(i / 30.0) + '\n';
  }
  folder.write("s.frames.csv", frames);
  folder.write("s.nodes.csv", program::read_file(sample_query + ".nodes.csv"));
  const std::string set = folder.path("s");
  const std::string told = "--world-up: no key frame of " + set +
                           " has a pose, by which it would "
                           "know which way is down; give --trajectory, or leave it out";
  const std::string up = used_camera + "--world-up 0,0,1 --nodes " + set;
  CHECK(refusal("loops" + up) == told);
  CHECK(refusal("map --out " + folder.path("m.bag") + up) == told);
  CHECK_FALSE(std::filesystem::exists(folder.path("m.bag")));
}

TEST_CASE("options of a network are refused beside boxes", "[examples][regression]") {
  for (const std::string option :
       {"--head yolov8", "--input-size 416", "--nms 0.5", "--min-confidence 0.5"}) {
    CHECK(
        refusal("nodes --images a --boxes b --out c --camera 517.3,516.5,318.6,255.3 " + option) ==
        option.substr(0, option.find(' ')) + " requires --model; see topobag nodes --help");
  }
}
