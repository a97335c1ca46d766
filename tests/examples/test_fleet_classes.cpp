// SPDX-License-Identifier: MIT
#include <string>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "own_classes.hpp"
#include "run_program.hpp"

namespace {

/// The address of a data base of its own, with more of it after the `?`.
std::string warehouse_address(const std::string& query) {
  const std::string info = shared_postgres().new_base();
  return "'postgresql://owner@/" + info.substr(info.find("dbname=") + 7) +
         "?host=" + shared_postgres().data() + "&" + query + "'";
}

}  // namespace

TEST_CASE("a fleet's site keeps its classes, goes by them, and refuses others",
          "[examples][fleet]") {
  if (!PostgresServer::is_installed()) return;
  const OwnClasses own;
  const std::string hall = warehouse_address("site=hall");
  const std::string map = own.first.write_table(own.folder, "map");
  const std::string query = own.second.write_table(own.folder, "query");
  REQUIRE(run_program("fleet init " + hall + own.option).exit_code == 0);
  REQUIRE(run_program("map --nodes " + map + warehouse_camera + "--out " + hall).exit_code == 0);
  const auto objects = own_json("info " + hall + ' ').at("objects");
  CHECK(objects.size() == 17);
  CHECK_FALSE(objects.contains("forklift"));
  CHECK(objects == own_json("info " + hall + own.option + ' ').at("objects"));
  CHECK(own_json("localize --map " + hall + " --query " + query + warehouse_camera).at("accepted") >
        0);
  CHECK(own_json("loops --min-gap 10 --nodes " + hall + warehouse_camera).at("accepted") > 0);
  const ProgramRun followed = run_program("fleet follow --seconds 0 " + hall);
  CHECK(followed.out.find("25 key frames of 1 sessions") != std::string::npos);

  std::string text = warehouse_classes;
  const std::string changed =
      own.folder.write("changed.txt", text.replace(text.find(", high"), 6, ", low"));
  const std::string says =
      "site 'hall': class 'forklift' is of high dynamics in the map and of low in " + changed +
      "; take the classes that it was made with";
  const std::string option = " --classes " + changed + ' ';
  CHECK(refusal("info " + hall + option) == says);
  CHECK(refusal("map --nodes " + query + warehouse_camera + option + "--out " + hall) == says);

#ifdef TOPOBAG_HAS_SQLITE
  const std::string robot = own.folder.path("robot.db");
  REQUIRE(run_program("map --nodes " + query + warehouse_camera + option + "--out " + robot)
              .exit_code == 0);
  CHECK(refusal("fleet push --map " + robot + ' ' + hall)
            .find("dynamics in the map and of low in " + robot) != std::string::npos);
  const std::string right = own.folder.path("right.db");
  REQUIRE(run_program("map --nodes " + query + own.options + "--out " + right).exit_code == 0);
  CHECK(run_program("fleet push --map " + right + ' ' + hall).exit_code == 0);
  CHECK(own_json("info " + hall + ' ').at("sessions").size() == 2);
#endif
}
