// SPDX-License-Identifier: MIT
// What a newcomer does wrong with a fleet, against a server of the test's own: it is told, and
// nothing is changed by it.
#include <algorithm>
#include <string>

#include "catch.hpp"
#include "fleet_base.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

/// A server with a site of COCO's classes and one of others, and a robot's map of COCO's.
struct TwoSites {
  FleetBase base;
  ScratchFolder folder;
  std::string own_classes = folder.write("own.txt", "pallet\ncrate\n");
  std::string map = folder.path("robot.db");
  std::string kitchen = base.address("site=kitchen"), depot = base.address("site=depot");

  TwoSites() {
    fleet_output("fleet init " + kitchen);
    fleet_output("fleet init " + depot + " --classes " + own_classes);
    fleet_output("map --nodes " + sample_map + sample_options + "--out " + map);
  }
};

}  // namespace

TEST_CASE("a push that is refused leaves the map as it was", "[examples][fleet][regression]") {
  if (!PostgresServer::is_installed()) return;
  const TwoSites sites;
  shared_postgres().sql("CREATE ROLE droid LOGIN");
  fleet_output("fleet admit --role droid " + sites.kitchen);  // reads alone
  const std::string before = content_of(sites.map);
  const std::string push = "fleet push --map " + sites.map + " ";
  const std::string other_classes =
      sites.base.name() +
      "the classes of site 'depot' mean other names than the map's; make the map with those";
  CHECK(refusal(push + sites.depot) == other_classes);
  // By the classes of the site, as none are given.
  CHECK(refusal("map --nodes " + sample_map + sample_options + "--out " + sites.depot) ==
        sample_map + ".nodes.csv:2: unknown class 'person'; nearest known: 'crate' 'pallet'");
  const std::string robot = "00000000-0000-4000-8000-000000000009";
  CHECK(refusal(push + sites.base.address("site=kitchen&robot=" + robot, "droid")) ==
        sites.base.name() + "this role may not add key frames of robot " + robot +
            " at site 'kitchen'; the owner admits it with `topobag fleet admit`");
  CHECK(content_of(sites.map) == before);
  CHECK(sites.base.sql("SELECT count(*) FROM topobag.version") == "0");
  CHECK(fleet_output(push + sites.kitchen) == "67 versions of " + sites.map + " added\n");
}

TEST_CASE("a follower that could read nothing fails, and tells why once",
          "[examples][fleet][regression]") {
  if (!PostgresServer::is_installed()) return;
  const TwoSites sites;
  const ScratchFolder nowhere;
  const std::string unreachable = "'postgresql://owner@/base?site=a&host=" + nowhere.path() + "'";
  CHECK(refusal("fleet follow --seconds 0 " + unreachable)
            .find("nothing could be read in 0 s: PostgreSQL at " + nowhere.path()) == 0);
  const ProgramRun longer = run_program("fleet follow --seconds 1 " + unreachable);
  CHECK(longer.exit_code == 2);
  CHECK(longer.out.empty());
  CHECK(std::count(longer.err.begin(), longer.err.end(), '\n') == 2);  // at once, and at the end

  fleet_output("fleet push --map " + sites.map + " " + sites.kitchen);
  const std::string others = " --classes " + sites.own_classes + " ";
  const std::string told = refusal("fleet follow --seconds 1" + others + sites.kitchen);
  CHECK(told.find("67 key frames cannot be taken, the first of site 'kitchen', robot ") == 0);
  CHECK(told.find("its class numbers mean other names than yours") != std::string::npos);
  CHECK(refusal("info" + others + sites.kitchen).find("67 key frames cannot be taken") !=
        std::string::npos);
  CHECK(fleet_output("fleet follow --seconds 0 " + sites.kitchen) ==
        "67 key frames of 1 sessions\n");
}

TEST_CASE("what a fleet's owner names has to be there, and as it was",
          "[examples][fleet][regression]") {
  if (!PostgresServer::is_installed()) return;
  const TwoSites sites;
  const std::string nope = sites.base.address("site=nope");
  CHECK(refusal("fleet status " + nope) ==
        "the server has no site 'nope' that this role may read; `topobag fleet status` names those "
        "that it has");
  CHECK(fleet_output("fleet status " + sites.depot) == "depot: 0 versions of 0 robots\n");
  CHECK(refusal("fleet init " + sites.base.address("site=attic&site=kitchen") + " --classes " +
                sites.own_classes) ==
        sites.own_classes +
            ": site 'kitchen' exists with other classes, which are for ever; give another "
            "site=NAME");
  CHECK(sites.base.sql("SELECT count(*) FROM topobag.site") == "2");
  CHECK(fleet_output("fleet init " + sites.depot + " --classes " + sites.own_classes) ==
        "prepared\n");
  CHECK(refusal("fleet admit --role nobody_there " + sites.kitchen) ==
        "--role nobody_there: the server has no role 'nobody_there'; CREATE ROLE makes one");
  CHECK(sites.base.sql("SELECT count(*) FROM topobag.access") == "0");
}

TEST_CASE("an address that cannot be read is told without what it lacks",
          "[examples][fleet][regression]") {
  CHECK(refusal("fleet status 'postgresql://localhost:1/x?sitte=a'")
            .find("PostgreSQL: invalid URI query parameter") == 0);
  // Without an end: a follower does not try for ever what can never be read.
  CHECK(refusal("fleet follow 'postgresql://localhost:1/x?site=a&hots=b'") ==
        "PostgreSQL: invalid URI query parameter: \"hots\"");
}
