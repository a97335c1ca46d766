// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "catch.hpp"
#include "run_program.hpp"

TEST_CASE("the program helps", "[examples]") {
  const ProgramRun help = run_program("--help");
  CHECK(help.exit_code == 0);
  CHECK(help.err.empty());
  CHECK(help.out.find("nodes") != std::string::npos);
  const ProgramRun version = run_program("--version");
  CHECK(version.exit_code == 0);
  CHECK(std::count(version.out.begin(), version.out.end(), '.') == 2);
}

TEST_CASE("wrong arguments end the program with one line and exit code 2", "[examples]") {
  CHECK(refusal("") == "A subcommand is required; see topobag --help");
  CHECK(refusal("localise --map x") == "there is no command 'localise'; see topobag --help");
  refusal("fly");
  CHECK(refusal("nodes") == "--images is required; see topobag nodes --help");
  const std::string nodes = "nodes --images nowhere --model nothing --out nodes ";
  CHECK(refusal(nodes) == "--camera is required; see topobag nodes --help");
  CHECK(refusal(nodes + "--camera 500,500,320") ==
        "--camera 500,500,320: there are not 4 or 6 numbers; give fx,fy,cx,cy or "
        "fx,fy,cx,cy,width,height");
  CHECK(refusal(nodes + "--camera 500,nan,320,240").find("'nan' is not a number") !=
        std::string::npos);
  CHECK(refusal(nodes + "--camera 500,-500,320,240").find("fx, fy > 0") != std::string::npos);
  CHECK(refusal(nodes + "--camera 500,500,320,240,0,480").find("image size") != std::string::npos);
  refusal(nodes + "--camera 500,500,320,240 --depth-scale -1");
}

TEST_CASE("missing input ends the program with its name and exit code 2", "[examples]") {
  CHECK(refusal("nodes --images nowhere --model nothing --out nodes --camera 500,500,320,240") ==
        "nowhere/depth.txt: the file cannot be opened; check the path");
  CHECK(refusal("nodes --images nowhere --model nothing --out no/where --camera 5,5,3,2") ==
        "--out no/where: the folder does not exist; make it first");
}
