// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/postgres_server.hpp"
#include "bag/warehouse_catalogs.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

const std::uint64_t warehouse_names = fingerprint(warehouse().catalog);

/// Pushes so many key frames of the warehouse's classes.
void push_to(const std::string& conninfo, const std::string& site, std::size_t count) {
  std::mt19937 random(static_cast<unsigned>(site.size()));
  std::vector<FleetVersion> versions;
  const Uuid robot = random_uuid();
  for (std::size_t i = 0; i < count; ++i) {
    versions.push_back(
        version_of({site, robot, Uuid{1}, KeyframeId{i}}, {}, random_graph(random, 4)));
    versions.back().seq = static_cast<std::int64_t>(i) + 1;
    versions.back().catalog = warehouse_names;
  }
  CHECK(PostgresStore(conninfo).append(versions) == count);
}

/// Three sites of the warehouse's classes, which say all of them, their names, and nothing.
std::string three_sites() {
  const std::string conninfo = shared_postgres().new_base();
  PostgresStore store(conninfo);
  store.prepare();
  store.add_site("hall", warehouse());
  store.add_site("names", warehouse().catalog);
  store.add_site("old", warehouse_names);
  push_to(conninfo, "hall", 4);
  push_to(conninfo, "names", 2);
  push_to(conninfo, "old", 1);
  return conninfo;
}

FleetBag fleet_with(const std::string& conninfo, const DescribedCatalog& classes) {
  FleetOptions options;
  options.classes = classes;
  return FleetBag({{conninfo, {"hall", "names", "old"}}}, options);
}

/// What `follow` says behind the server's name.
std::string said_by(FleetBag& fleet) {
  const std::string text = error_text([&] { fleet.follow(); });
  CHECK(text.find("PostgreSQL at ") == 0);
  return text.substr(text.find("site '"));
}

}  // namespace

TEST_CASE("a fleet's bag takes sites that say of their classes what its user says", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  for (const DescribedCatalog& classes : {warehouse(), DescribedCatalog(warehouse().catalog)}) {
    const std::string conninfo = three_sites();
    FleetBag fleet = fleet_with(conninfo, classes);
    CHECK(fleet.follow() == 7);
    push_to(conninfo, "hall", 1);
    CHECK(fleet.follow() == 1);
    CHECK(fleet.size() == 8);
    CHECK(fleet.refused().empty());
  }
}

TEST_CASE("a fleet's bag hands out what its sites say of their classes", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = three_sites();
  FleetBag fleet({{shared_postgres().new_base(), {"yard"}}, {conninfo, {"hall", "names", "old"}}});
  const auto kept = fleet.site_catalog("hall");
  REQUIRE(kept);
  CHECK_FALSE(difference(*kept, warehouse()));
  CHECK(*kept->sizes == *warehouse().sizes);
  REQUIRE(fleet.site_catalog("names"));
  CHECK_FALSE(fleet.site_catalog("names")->sizes);
  CHECK_FALSE(fleet.site_catalog("old"));
  CHECK_FALSE(fleet.site_catalog("depot"));
  CHECK(error_text([&] { fleet.site_catalog("yard"); }).find("holds no fleet's map") !=
        std::string::npos);
  CHECK(fleet_with(conninfo, *kept).follow() == 7);
}

TEST_CASE("a site that says something else of the classes is refused, and no other", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = three_sites();
  for (const auto& [classes, sentence] : other_warehouses()) {
    // The site that says the names alone has their dynamics too.
    const bool slower = classes.catalog.dynamics(ClassId{-3}) == Dynamics::low;
    FleetBag fleet = fleet_with(conninfo, classes);
    for (int round = 0; round < 2; ++round) {
      CHECK(said_by(fleet) ==
            "site 'hall': " + sentence + "; open it with the classes that it was made with");
      CHECK(fleet.size() == (slower ? 1 : 3));
      CHECK(fleet.refused().empty());
    }
  }
  FleetBag coco = fleet_with(conninfo, ClassCatalog::coco80());
  CHECK(said_by(coco) ==
        "site 'hall': its class numbers mean other names than yours; open it with the catalog that "
        "it was made with");
  CHECK(coco.size() == 0);
  CHECK(coco.refused().size() == 1);  // of the site that says nothing
}

TEST_CASE("a site is asked what it says before the first of its key frames is taken", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = shared_postgres().new_base();
  PostgresStore store(conninfo);
  store.prepare();
  const DescribedCatalog other = other_warehouses().front().first;
  FleetBag fleet = fleet_with(conninfo, other);
  CHECK(fleet.follow() == 0);
  store.add_site("names", other);
  push_to(conninfo, "names", 2);
  CHECK(fleet.follow() == 2);
  store.add_site("hall", warehouse());
  CHECK(said_by(fleet).find(other_warehouses().front().second) != std::string::npos);
  push_to(conninfo, "hall", 3);
  CHECK_THROWS_AS(fleet.follow(), FormatError);
  push_to(conninfo, "names", 1);
  CHECK_THROWS_AS(fleet.follow(), FormatError);
  CHECK(fleet.size() == 3);
}

TEST_CASE("a fingerprint of the classes goes by their names alone", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = three_sites();
  FleetOptions options;
  for (const std::uint64_t catalog : {std::uint64_t{0}, warehouse_names}) {
    options.catalog = catalog;
    FleetBag fleet({{conninfo, {"hall", "names", "old"}}}, options);
    CHECK(fleet.follow() == 7);
    CHECK(fleet.size() == 7);
  }
  options.catalog = 78;
  FleetBag others({{conninfo, {"hall"}}}, options);
  CHECK(others.follow() == 4);
  CHECK(others.size() == 0);
  REQUIRE(others.refused().size() == 4);
  CHECK(others.refused().front().find("mean other names than yours") != std::string::npos);
}
