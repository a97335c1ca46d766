// SPDX-License-Identifier: MIT
// The program's fleet commands, against a server of the test's own.
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "fleet_base.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

nlohmann::json fleet_json(const std::string& arguments) {
  return nlohmann::json::parse(fleet_output(arguments));
}

}  // namespace

TEST_CASE("a table that is mapped to a server answers as one that is mapped to a file",
          "[examples][fleet]") {
  if (!PostgresServer::is_installed()) return;
  const FleetBase base;
  const ScratchFolder folder;
  const std::string hall = base.address("site=hall"), file = folder.path("map.bag");
  CHECK(fleet_output("fleet init " + base.address("site=hall&site=yard")) == "prepared\n");
  const std::string map = "map --nodes " + sample_map + sample_options + "--out ";
  CHECK(fleet_output(map + hall) ==
        base.plain_address("site=hall") + ": 67 key frames of fr1_xyz added to the fleet's map\n");
  fleet_output(map + file);
  CHECK(refusal(map + hall).find("holds these key frames already") != std::string::npos);
  CHECK(fleet_output("fleet status " + base.address()) ==
        "hall: 67 versions of 1 robots\nyard: 0 versions of 0 robots\n");

  auto at_server = fleet_json("info --json " + hall), in_file = fleet_json("info --json " + file);
  CHECK(at_server.at("format") == "PostgreSQL, schema 2");
  CHECK(at_server.at("file_bytes").is_null());
  CHECK(at_server.at("keyframes") == 67);
  CHECK(at_server.at("objects") == in_file.at("objects"));
  CHECK(at_server.at("graph_bytes_per_keyframe") == in_file.at("graph_bytes_per_keyframe"));
  const std::string name = at_server.at("sessions").at("0").at("name");
  CHECK(name.rfind("hall, robot ", 0) == 0);
  CHECK(name.substr(name.size() - 9) == ", fr1_xyz");

  const std::string query = " --json --query " + sample_query + sample_options + "--map ";
  const auto found = fleet_json("localize" + query + hall);
  const auto expected = fleet_json("localize" + query + file);
  CHECK(found.at("accepted").get<int>() > 50);
  for (const char* key : {"keyframes", "map_keyframes", "queries", "accepted", "wrong"}) {
    CHECK(found.at(key) == expected.at(key));
  }
  const char* const median = "median_translation_error_m";  // a quaternion's rounding apart
  CHECK(found.at(median).get<double>() == Approx(expected.at(median).get<double>()));
  const auto loops = fleet_json("loops --json --nodes " + hall + sample_options);
  CHECK(loops.at("keyframes") == 67);
}

TEST_CASE("a robot pushes its map, and a follower of the program's tells of it",
          "[examples][fleet]") {
  if (!PostgresServer::is_installed()) return;
  const FleetBase base;
  const ScratchFolder folder;
  const std::string map = folder.path("robot.db"), robot = "00000000-0000-4000-8000-000000000007";
  shared_postgres().sql("CREATE ROLE c3po LOGIN; CREATE ROLE leia LOGIN");
  fleet_output("fleet init " + base.address("site=hall&site=yard"));
  fleet_output("map --nodes " + sample_map + sample_options + "--out " + map);
  CHECK(fleet_output("fleet admit " + base.address("site=hall&robot=" + robot) + " --role c3po") ==
        "c3po admitted\n");
  fleet_output("fleet admit " + base.address("site=hall") + " --role leia");

  const std::string push = "fleet push --map " + map + " ";
  const std::string as_robot = base.address("site=hall&robot=" + robot, "c3po");
  CHECK(fleet_output(push + as_robot) == "67 versions of " + map + " added\n");
  CHECK(fleet_output(push + base.address("site=hall", "c3po")) ==
        "0 versions of " + map + " added\n");
  fleet_output("map --append --nodes " + sample_query + sample_options + "--out " + map);
  CHECK(fleet_output(push + as_robot) == "61 versions of " + map + " added\n");
  CHECK(fleet_output("fleet follow --seconds 0 " + base.address("site=hall", "leia")) ==
        "128 key frames of 2 sessions\n");
  CHECK(fleet_output("fleet status " + base.address("", "leia")) ==
        "hall: 128 versions of 1 robots\n");

  // Who may not, is told what to do.
  CHECK(refusal("fleet follow --seconds 0 " + base.address("site=yard", "leia")) ==
        "the server has no site 'yard' that this role may read; `topobag fleet status` names those "
        "that it has");
  const std::string other = folder.path("other.db");
  fleet_output("map --nodes " + sample_query + sample_options + "--out " + other);
  const std::string denied =
      refusal("fleet push --map " + other + " " + base.address("site=hall", "c3po"));
  CHECK(denied.find("the owner admits it with `topobag fleet admit`") != std::string::npos);
  CHECK(refusal(push + base.address("site=yard"))
            .find("it is the map of robot " + robot + " at site 'hall'") != std::string::npos);
  CHECK(base.sql("SELECT count(*) FROM topobag.version") == "128");
}

TEST_CASE("likely mistakes with a fleet are told in a sentence", "[examples][fleet]") {
  if (!PostgresServer::is_installed()) return;
  const FleetBase base, empty;
  const ScratchFolder folder;
  const std::string map = folder.path("robot.db"), none = folder.path("none.db");
  const std::string hall = base.address("site=hall"), attic = base.address("site=attic");
  fleet_output("fleet init " + hall);
  fleet_output("map --nodes " + sample_map + sample_options + "--out " + map);
  fleet_output("map --nodes " + sample_map + sample_options + "--out " + folder.path("map.bag"));
  folder.write("own.txt", "pallet\ncrate\n");
  const std::string to_server = "map --nodes " + sample_map + sample_options + "--out ";
  const std::string no_attic =
      "the server has no site 'attic' that this role may read; `topobag fleet status` names those "
      "that it has";
  const std::string not_prepared =
      empty.name() + "it holds no fleet's map; its owner prepares it with `topobag fleet init`";
  const std::string many = "the address names 2 sites; a robot maps one: give one site=NAME";
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"fleet",
       "'fleet' is followed by one of its commands: init, admit, push, follow, status; see topobag "
       "fleet --help"},
      {"fleet push " + hall, "--map is required; see topobag fleet push --help"},
      {"fleet admit " + hall, "--role is required; see topobag fleet admit --help"},
      {"fleet admit --role r2d2 " + base.address(), "the address names no site; give site=NAME"},
      {"fleet status", "address is required; see topobag fleet status --help"},
      {"fleet status map.db",
       "map.db: it is no server's address, as postgresql://USER@HOST/BASE?site=NAME is"},
      {"fleet status postgresql://owner:secret@host/base",
       "the address holds a password, which others would see; give it in PGPASSWORD or ~/.pgpass"},
      {"fleet status " + empty.address(), not_prepared},
      {"info " + empty.address(), not_prepared},
      {"fleet push --map " + map + " " + empty.address("site=hall"), not_prepared},
      {"fleet push --map " + none + " " + hall,
       none + ": the file cannot be opened; check the path"},
      {"fleet push --map " + sample_map + " " + hall,
       sample_map + ": it is a table, no map; `topobag map` makes one of it"},
      {"fleet push --map " + folder.path("map.bag") + " " + hall,
       folder.path("map.bag") + ": it is a snapshot, which no robot goes on with; `topobag map "
                                "--out FILE.db` makes an SQLite map"},
      {"fleet push --map " + map + " " + attic, no_attic},
      {"fleet push --map " + map + " " + base.address(),
       "the address names 0 sites; a robot maps one: give one site=NAME"},
      {"fleet push --map " + map + " " + base.address("site=hall&robot=r2d2"),
       "'r2d2' is no UUID: 32 hexadecimal digits, as in 123e4567-e89b-42d3-a456-426614174000"},
      {"fleet follow --seconds -1 " + hall,
       "--seconds: '-1' is not a whole number in [0, inf); see topobag fleet follow --help"},
      {"fleet follow --seconds 0 " + attic, no_attic},
      {"info " + attic, no_attic},
      {"localize --query " + sample_query + sample_options + "--map " + attic, no_attic},
      {"localize --query " + sample_query + sample_options + "--map " + hall,
       base.plain_address("site=hall") + ": the map holds no key frame"},
      {"loops" + sample_options + "--nodes " + attic, no_attic},
      {to_server + attic, no_attic},
      {to_server + base.address("site=hall&site=attic"), no_attic},
  };
  for (const auto& [arguments, sentence] : mistakes) CHECK(refusal(arguments) == sentence);
  CHECK_FALSE(std::filesystem::exists(none));
  CHECK_FALSE(std::filesystem::exists(sample_map));
  fleet_output("fleet init " + base.address("site=yard"));
  CHECK(refusal(to_server + base.address("site=hall&site=yard")) == many);
  CHECK(refusal("fleet push --map " + map + " " + base.address("site=hall&site=yard")) == many);
  CHECK(base.sql("SELECT count(*) FROM topobag.version") == "0");

  // None of it has made the map another's: it still goes where it belongs. Then other classes.
  CHECK(fleet_output("fleet push --map " + map + " " + hall) ==
        "67 versions of " + map + " added\n");
  CHECK(refusal("info " + hall + " --classes " + folder.path("own.txt"))
            .find("its class numbers mean other names than yours") != std::string::npos);
  fleet_output("fleet init " + base.address("site=depot") + " --classes " + folder.path("own.txt"));
  // The site's classes hold where none are given, and the sample's objects are none of them.
  CHECK(refusal(to_server + base.address("site=depot"))
            .find(sample_map + ".nodes.csv:2: unknown class '") == 0);
  const std::string unreachable =
      refusal("fleet status 'postgresql://owner@/base?host=" + folder.path() + "'");
  CHECK(unreachable.find("Is the server running") != std::string::npos);
}
