// SPDX-License-Identifier: MIT
#include <string>

#include "catch.hpp"
#include "run_program.hpp"

namespace {
const std::string complaint_camera = " --camera 517.3,516.5,318.6,255.3";
const std::string complaint_tables = "localize --map a --query b" + complaint_camera;
}  // namespace

TEST_CASE("a misspelt option is named before what is missing without it",
          "[examples][regression]") {
  CHECK(refusal("localize --map a --query b --cammera 1,1,1,1") ==
        "there is no option --cammera; there is --camera; see topobag localize --help");
  CHECK(refusal("evaluate --score=a --poses b") ==
        "there is no option --score; there is --scores; see topobag evaluate --help");
  CHECK(refusal(complaint_tables + " --frame 3") ==
        "there is no option --frame; see topobag localize --help");
  CHECK(refusal("fleet push postgresql://host/base --mop a.db") ==
        "there is no option --mop; there is --map; see topobag fleet push --help");
  CHECK(refusal(complaint_tables + " -x") == "there is no option -x; see topobag localize --help");
}

TEST_CASE("a misspelt command of a command is named", "[examples][regression]") {
  CHECK(refusal("fleet list") == "there is no command 'fleet list'; see topobag fleet --help");
}

TEST_CASE("an option that is given twice is told so", "[examples][regression]") {
  CHECK(refusal(complaint_tables + complaint_camera) ==
        "--camera is given twice; see topobag localize --help");
  CHECK(refusal("evaluate --scores a --poses b --seed 1 --seed 2") ==
        "--seed is given twice; see topobag evaluate --help");
}

TEST_CASE("what is not the idx of a frame is told so by every command that takes one",
          "[examples][regression]") {
  const std::string no_frame = "' is not the idx of a frame, a whole number; see topobag ";
  const std::string similarity = "similarity --nodes a" + complaint_camera + " --frames ";
  CHECK(refusal(similarity + "0-43") == "--frames: '0-43" + no_frame + "similarity --help");
  CHECK(refusal(similarity + "''") == "--frames: '" + no_frame + "similarity --help");
  const std::string explain = "explain --map a --query b" + complaint_camera + " --frame ";
  CHECK(refusal(explain + "21,43") == "--frame: '21,43" + no_frame + "explain --help");
  CHECK(refusal(explain + "1305031229.5") ==
        "--frame: '1305031229.5" + no_frame + "explain --help");
}
