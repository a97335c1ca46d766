// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "catch.hpp"
#include "run_program.hpp"
#include "sample.hpp"

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
  CHECK(refusal("") == "give a command; see topobag --help");
  CHECK(refusal("--map x") ==
        "a command comes first, then its options such as --map; see topobag --help");
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
        "nowhere: there is no such folder");
  CHECK(refusal("nodes --images nowhere --model nothing --out no/where --camera 500,500,320,240") ==
        "--out no/where: the folder does not exist; make it first");
}

TEST_CASE("likely mistakes are told in one sentence that says what to do", "[examples]") {
  const std::string frames = sample_map + ".frames.csv";
  CHECK(refusal("trajectory --groundtruth " + frames + " --estimate " + frames +
                " --alignment sim2") ==
        "--alignment: 'sim2' is none of none, se3, sim3; see topobag trajectory --help");
  CHECK(refusal("similarity --frames 0-5 --camera 500,500,320,240 --nodes " + sample_map) ==
        "--frames: '0-5' is not the idx of a frame, a whole number; see topobag similarity "
        "--help");
  CHECK(refusal("similarity --nodes " + sample_map + sample_options.substr(0, 34)) ==
        frames + ": there is no frame idx 196; name others by --frames");
  const ScratchFolder folder;
  CHECK(refusal("info " + folder.path()) == folder.path() + ": it is a folder; name the map in it");
  CHECK(refusal("map --nodes " + sample_map + sample_options + "--out " + folder.path()) ==
        "--out " + folder.path() + ": it is a folder; name a file in it");
  CHECK(refusal("loops --protocol distance=far --nodes " + sample_map + sample_options)
            .find("distance") != std::string::npos);
  const ProgramRun run = run_program("localize --map " + sample_map + ".nodes.csv --query " +
                                     sample_query + ".frames.csv" + sample_options);
  CHECK(run.exit_code == 0);  // either file of a table stands for it
}
