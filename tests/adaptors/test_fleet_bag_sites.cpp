// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/fleet_robots.hpp"
#include "adaptors/postgres_proxy.hpp"
#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// Runs a file of the example as its reader would.
bool run_example_sql(const std::string& file, const std::string& conninfo,
                     const std::string& variables = {}) {
  return std::system(("PGOPTIONS=--client-min-messages=warning psql -q -v ON_ERROR_STOP=1 " + variables + " -f " TOPOBAG_SOURCES
                      "/examples/fleet/" + file + " '" + conninfo + "'").c_str()) == 0;
}

/// Follows until the bag has so many key frames; false when that takes half a minute.
bool reaches(FleetBag& fleet, std::size_t size) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (std::chrono::steady_clock::now() < end) {
    fleet.follow();
    if (fleet.size() == size) return true;
    fleet.wait();
  }
  return false;
}

}  // namespace

TEST_CASE("a site's key frames reach the centre, whatever the link does", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::vector<std::string> settings{"wal_level=logical", "wal_retrieve_retry_interval=100ms"};
  PostgresServer site(settings), centre(settings);
  std::mt19937 random(8);
  const ScratchFolder folder;
  for (PostgresServer* server : {&site, &centre}) {
    PostgresStore store(server->conninfo());
    store.prepare();
    store.add_site("hall", 0);
    store.add_site("yard", 0);
  }
  PostgresProxy link(site.data());
  REQUIRE(run_example_sql("site.sql", site.conninfo()));
  SimulatedRobot in_hall(folder.path(), "hall", 0), in_yard(folder.path(), "yard", 0);
  PostgresStore at_site(site.conninfo()), at_centre(centre.conninfo());
  const auto drive = [&] {
    for (int i = 0; i < 20; ++i) in_hall.add(random, random_graph(random, 6));
    in_hall.update(random, random_graph(random, 6));
    in_hall.erase(random);
    push(in_hall.outbox(), at_site);
    in_yard.add(random, random_graph(random, 6));
    push(in_yard.outbox(), at_centre);
  };
  const auto all = [&] {
    FleetUnion known;
    in_hall.tell(known);
    in_yard.tell(known);
    return known;
  };
  const std::vector<TopologyGraph<>> queries{random_graph(random, 6), random_graph(random, 4)};
  FleetBag far({{centre.conninfo(), {"hall", "yard"}}});
  FleetBag both({{site.conninfo(), {"hall"}}, {centre.conninfo(), {"yard"}}});
  drive();  // what is there already is copied
  REQUIRE(run_example_sql("centre.sql", centre.conninfo(),
                          "-v name=hall -v from='host=" + link.folder() +
                              " user=owner dbname=postgres'"));
  REQUIRE(reaches(far, all().size()));
  drive();  // what comes then wakes the follower
  REQUIRE(reaches(far, all().size()));
  require_union(*far.view(), all(), queries);

  link.set(PostgresProxy::Fault::cut, 0);
  const std::size_t in_hall_before = in_hall.map().bag().size();
  drive();
  REQUIRE(reaches(both, all().size()));
  require_union(*both.view(), all(), queries);
  REQUIRE(reaches(far, in_hall_before + in_yard.map().bag().size()));
  centre.crash();
  centre.start();
  link.set(PostgresProxy::Fault::cut, PostgresProxy::never);
  CHECK_THROWS_AS(far.follow(), Error);  // the connection is lost, and made again
  REQUIRE(reaches(far, all().size()));
  require_union(*far.view(), all(), queries);
  for (FleetBag* fleet : {&far, &both}) CHECK(fleet->refused().empty());
}
