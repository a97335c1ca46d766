// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

TEST_CASE("similarity compares frames with the first", "[examples]") {
  const std::string command =
      "similarity --nodes " + sample_map + " --camera 517.3,516.5,318.6,255.3 --frames 3,9,40,3";
  const ProgramRun run = run_program(command + " --json");
  REQUIRE(run.exit_code == 0);
  const auto frames = nlohmann::json::parse(run.out).at("frames");
  REQUIRE(frames.size() == 4);
  CHECK(frames[1].at("frame") == 9);
  for (const char* column : {"paper", "raw_z", "sorted", "assigned", "default"}) {
    CAPTURE(column);
    CHECK(frames[0].at(column).get<double>() == Approx(1.0));
    CHECK(frames[3].at(column) == frames[0].at(column));
    CHECK(frames[2].at(column) < 1.0);
    CHECK(frames[2].at(column) >= 0.0);
  }
  CHECK_FALSE(frames[0].contains("published"));
  CHECK(run_program(command).out.find("paper") != std::string::npos);
}

TEST_CASE("the published values stand beside the paper's frames alone", "[examples]") {
  const std::string options = " --camera 517.3,516.5,318.6,255.3";
  CHECK(refusal("similarity --nodes " + sample_map + options) ==
        sample_map + ".frames.csv: there is no frame idx 196; name others by --frames");
  const ScratchFolder folder;
  std::string frames = "idx,frame,timestamp\n";
  for (int i = 0; i < 200; ++i) frames += std::to_string(i) + ",a," + std::to_string(i) + "\n";
  folder.write("s.frames.csv", frames);
  folder.write("s.nodes.csv", "idx,class,conf,u,v,w,h,z\n0,cup,0.9,200,200,40,40,1\n");
  const ProgramRun run = run_program("similarity --json --nodes " + folder.path("s") + options);
  REQUIRE(run.exit_code == 0);
  const auto rows = nlohmann::json::parse(run.out).at("frames");
  CHECK(rows[1].at("published") == 0.95);
  CHECK(rows[1].at("paper") == 0.0);  // no objects, no similarity
}

TEST_CASE("similarity to a frame without an object is refused, and of one is told",
          "[examples][regression]") {
  const std::string options = " --camera 517.3,516.5,318.6,255.3";
  const ScratchFolder folder;
  folder.write("s.frames.csv", "idx,frame,timestamp\n0,a,0\n1,b,1\n2,c,2\n");
  folder.write("s.nodes.csv",
               "idx,class,conf,u,v,w,h,z\n0,cup,0.9,200,200,40,40,1\n1,cup,0.2,200,200,40,40,1\n"
               "1,person,0.9,300,200,40,90,2\n1,tv,0.9,400,200,40,40,0\n");
  const std::string nodes = "similarity --nodes " + folder.path("s") + options + " --frames ";
  CHECK(refusal(nodes + "1,0") ==
        folder.path("s.nodes.csv") +
            ": frame 1 has no object to compare the others with; of its 3 detections 1 are below "
            "--min-confidence, 1 move by themselves, 1 have no depth, 0 are out of range, 0 too "
            "large, 0 not valid, 0 seen twice; name another frame first");
  CHECK(refusal(nodes + "2,2").find("of its 0 detections") != std::string::npos);
  const ProgramRun run = run_program(nodes + "0,1");
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("\nFrame 1 has no object: its similarity is 0 by definition.\n") !=
        std::string::npos);
  CHECK(run.out.find("Frame 0 has no object") == std::string::npos);
}
