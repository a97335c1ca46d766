// SPDX-License-Identifier: MIT
#include <chrono>
#include <random>
#include <string>
#include <vector>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/fleet_robots.hpp"
#include "adaptors/postgres_proxy.hpp"
#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

/// A version of a key frame as a robot would push it.
FleetVersion pushed_version(std::mt19937& random, const std::string& site, const Uuid& robot,
                            std::int64_t seq) {
  FleetVersion version;
  version.key = {site, robot, Uuid{1}, KeyframeId{static_cast<std::uint64_t>(seq)}};
  version.seq = seq;
  version.graph = encode(random_graph(random, 5));
  return version;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Rows of every site.
std::string rows_in(const std::string& conninfo) {
  return shared_postgres().sql("SELECT count(*) FROM topobag.version", conninfo);
}

std::string for_user(std::string conninfo, const std::string& user) {
  return conninfo.replace(conninfo.find("user=owner"), 10, "user=" + user);
}

}  // namespace

TEST_CASE("a robot adds its own key frames alone, a reader none", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(1);
  const std::string conninfo = shared_postgres().new_base();
  const Uuid mine{1}, other{2};
  PostgresStore owner(conninfo);
  owner.prepare();
  owner.prepare();  // again changes nothing
  owner.add_site("hall", 0);
  owner.add_site("yard", 0);
  for (const char* role : {"r2d2", "bob", "eve"}) {
    shared_postgres().sql(std::string("CREATE ROLE ") + role + " LOGIN");
  }
  owner.admit("r2d2", "hall", mine);
  owner.admit("bob", "hall");

  PostgresStore robot(for_user(conninfo, "r2d2"));
  CHECK(robot.append({pushed_version(random, "hall", mine, 1)}) == 1);
  const std::string says = "may not add key frames of robot";
  CHECK(holds(error_text([&] { robot.append({pushed_version(random, "hall", other, 2)}); }), says));
  CHECK(holds(error_text([&] { robot.append({pushed_version(random, "yard", mine, 2)}); }), says));
  CHECK(holds(error_text([&] {
                robot.append({pushed_version(random, "hall", mine, 2),
                              pushed_version(random, "hall", other, 3)});
              }),
              says));
  PostgresStore reader(for_user(conninfo, "bob"));
  CHECK(holds(error_text([&] { reader.append({pushed_version(random, "hall", mine, 2)}); }), says));
  CHECK(rows_in(conninfo) == "1");
  owner.append({pushed_version(random, "yard", other, 1)});

  FleetBag bobs({{for_user(conninfo, "bob"), {"hall", "yard"}}});
  CHECK(bobs.follow() == 1);
  FleetBag eves({{for_user(conninfo, "eve"), {"hall", "yard"}}});
  CHECK(eves.follow() == 0);
  owner.admit("eve", "hall");  // what was there before is read as well
  CHECK(eves.follow() == 1);
  CHECK(reader.sites().size() == 1);

  // Neither the robot nor the owner changes what is there, or says when it arrived.
  for (const char* sql : {"UPDATE topobag.version SET seq = 7", "DELETE FROM topobag.version"}) {
    CHECK_THROWS_AS(shared_postgres().sql(sql, for_user(conninfo, "r2d2")), std::runtime_error);
    CHECK_THROWS_AS(shared_postgres().sql(sql, conninfo), std::runtime_error);
  }
  CHECK_THROWS_AS(shared_postgres().sql("INSERT INTO topobag.version(arrival) VALUES ('1')",
                                        for_user(conninfo, "r2d2")),
                  std::runtime_error);
  CHECK_THROWS_AS(robot.add_site("attic", 0), Error);
  CHECK_THROWS_AS(robot.admit("r2d2", "yard", mine), Error);
}

TEST_CASE("names are names, whatever SQL is in them", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(2);
  const std::string conninfo = shared_postgres().new_base();
  PostgresStore store(conninfo);
  store.prepare();
  const std::string site = "'); DROP SCHEMA topobag CASCADE; --\"$1 %s %L";
  store.add_site(site, 0);
  FleetVersion version = pushed_version(random, site, Uuid{3}, 1);
  version.label = version.run = site + std::string(1, '\0') + "\\";
  CHECK(store.append({version}) == 1);
  FleetCursor cursor;
  const auto read = store.read(site, cursor);
  REQUIRE(read.size() == 1);
  CHECK(read.front().version.label == version.label);
  CHECK(read.front().version.run == version.run);
  CHECK(read.front().version.key.site == site);
  CHECK(holds(error_text([&] { store.admit("nobody'; DROP TABLE x; --", "no such site"); }),
              "foreign key"));
  CHECK(holds(error_text([&] { store.append({pushed_version(random, "attic", Uuid{3}, 2)}); }),
              "there is no site 'attic'"));
}

TEST_CASE("other classes, other schemas and copies of a map are refused", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(3);
  const std::string conninfo = shared_postgres().new_base();
  PostgresStore store(conninfo);
  CHECK(holds(error_text([&] { store.sites(); }), "holds no fleet's map"));
  store.prepare();
  store.add_site("hall", 77);
  FleetVersion version = pushed_version(random, "hall", Uuid{3}, 1);
  CHECK(holds(error_text([&] { store.append({version}); }), "mean other names"));
  version.catalog = 77;
  CHECK(store.append({version}) == 1);
  CHECK(store.append({version}) == 0);
  FleetVersion another = version;
  another.graph = encode(random_graph(random, 6));
  CHECK(holds(error_text([&] { store.append({another}); }), "a copy of the map is in use"));
  FleetOptions options;
  options.catalog = 78;
  FleetBag fleet({{conninfo, {"hall"}}}, options);
  CHECK(fleet.follow() == 1);
  CHECK(fleet.size() == 0);
  REQUIRE(fleet.refused().size() == 1);
  CHECK(holds(fleet.refused().front(), "mean other names than yours"));

  // A damaged row harms no other.
  shared_postgres().sql(
      "ALTER TABLE topobag.version DISABLE TRIGGER append_only;"
      "UPDATE topobag.version SET graph = '\\x00'",
      conninfo);
  another = pushed_version(random, "hall", Uuid{3}, 2);
  another.catalog = 77;
  store.append({another});
  FleetBag careful({{conninfo, {"hall"}}});
  CHECK(careful.follow() == 2);
  CHECK(careful.size() == 1);
  CHECK(holds(careful.refused().at(0), "damaged"));

  shared_postgres().sql("UPDATE topobag.meta SET schema_version = 99", conninfo);
  PostgresStore later(conninfo);
  CHECK(holds(error_text([&] { later.sites(); }), "later version of topobag (schema 99)"));
  CHECK(holds(error_text([&] { later.prepare(); }), "update topobag"));
  CHECK(rows_in(conninfo) == "2");
}

TEST_CASE("a link that is cut, silent or lies changes nothing and doubles nothing", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  const ScratchFolder folder;
  std::mt19937 random(6);
  const std::string conninfo = shared_postgres().new_base();
  PostgresStore owner(conninfo);
  owner.prepare();
  owner.add_site("hall", 0);
  SimulatedRobot robot(folder.path(), "hall", 0);
  for (int i = 0; i < 40; ++i) robot.add(random, random_graph(random, 6));
  PostgresProxy proxy(shared_postgres().data());
  const std::string through = "host=" + proxy.folder() + conninfo.substr(conninfo.find(" user="));
  const auto silence = std::chrono::milliseconds(300);
  FleetOptions options;
  options.silence = silence;
  FleetBag fleet({{through, {"hall"}}}, options);
  std::size_t failures = 0;
  for (const auto fault :
       {PostgresProxy::Fault::cut, PostgresProxy::Fault::garbage, PostgresProxy::Fault::silence}) {
    const bool silent = fault == PostgresProxy::Fault::silence;  // which takes its time
    for (int round = 0; round < (silent ? 2 : 9); ++round) {
      robot.add(random, random_graph(random, 6));
      proxy.set(fault, silent ? 100 + 1400U * static_cast<unsigned>(round) : random() % 3000);
      PostgresStore store(through, silence);
      const auto attempt = [&](const auto& call) {
        try {
          call();
        } catch (const Error& error) {
          ++failures;
          CHECK(holds(error.what(), "PostgreSQL at "));
        }
      };
      attempt([&] { push(robot.outbox(), store, 7); });
      attempt([&] { fleet.follow(); });
    }
  }
  CHECK(failures > 10);
  proxy.set(PostgresProxy::Fault::cut, PostgresProxy::never);
  PostgresStore store(through);
  push(robot.outbox(), store);
  CHECK(rows_in(conninfo) == std::to_string(robot.map().bag().size()));
  const auto follow = [&] { return error_text([&] { fleet.follow(); }); };
  for (int i = 0; i < 20 && follow() != "nothing was thrown"; ++i) {  // the machine may be slow
  }
  FleetUnion all;
  robot.tell(all);
  require_union(*fleet.view(), all, {random_graph(random, 6)});
}
