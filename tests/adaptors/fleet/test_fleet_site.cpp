// SPDX-License-Identifier: MIT
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <topobag/adaptors/postgres.hpp>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

TEST_CASE("a server tells its sites' classes, versions and robots", "[fleet][postgres]") {
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(7);
  PostgresStore store(shared_postgres().new_base());
  store.prepare();
  CHECK(store.sites().empty());
  const std::map<std::string, std::uint64_t> catalogs{{"hall", 0}, {"roof", 9}, {"yard", 7}};
  for (const auto& [name, catalog] : catalogs) store.add_site(name, catalog);
  std::map<std::string, std::size_t> versions;
  std::map<std::string, std::set<unsigned>> robots;
  for (int i = 0; i < 30; ++i) {
    const std::string site = random() % 2 == 0 ? "hall" : "yard";  // and none at the roof
    const auto robot = static_cast<std::uint8_t>(random() % 4);
    FleetVersion version =
        version_of({site, Uuid{robot}, Uuid{static_cast<std::uint8_t>(i)}, KeyframeId{1}}, {},
                   random_graph(random, 3));
    version.seq = 1;
    version.catalog = catalogs.at(site);
    REQUIRE(store.append({version}) == 1);
    ++versions[site];
    robots[site].insert(robot);
  }
  const std::vector<FleetSite> sites = store.sites();
  REQUIRE(sites.size() == 3);
  for (const FleetSite& site : sites) {
    CHECK(site.catalog == catalogs.at(site.name));
    CHECK(site.versions == versions[site.name]);
    CHECK(site.robots == robots[site.name].size());
  }
}
