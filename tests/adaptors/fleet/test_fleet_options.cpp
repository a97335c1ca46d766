// SPDX-License-Identifier: MIT
#include <topobag/adaptors/fleet/fleet_options.hpp>

#include <cstddef>
#include <random>
#include <string>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/postgres_server.hpp"
#include "bag/warehouse_catalogs.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

/// A server with one key frame of the warehouse's classes, seen by one camera.
std::string warehouse_server() {
  const std::string conninfo = shared_postgres().new_base();
  PostgresStore store(conninfo);
  store.prepare();
  store.add_site("hall", warehouse());
  std::mt19937 random(5);
  const TopologyGraph<> seen(random_graph(random, 5).nodes(), {}, {View<>{}});
  FleetVersion version = version_of({"hall", Uuid{1}, Uuid{2}, KeyframeId{3}}, {}, seen);
  version.seq = 1;
  version.catalog = fingerprint(warehouse().catalog);
  CHECK(store.append({version}) == 1);
  return conninfo;
}

FleetBag followed(const std::string& conninfo, const FleetOptions& options) {
  FleetBag fleet({{conninfo, {"hall"}}}, options);
  CHECK(fleet.follow() == 1);
  return fleet;
}

}  // namespace

TEST_CASE("a fleet is followed with its views, or without", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = warehouse_server();
  for (const bool kept : {true, false}) {
    FleetOptions options;
    if (!kept) options.views = ViewSection::left_out;
    const FleetBag fleet = followed(conninfo, options);
    std::size_t views = 0, graphs = 0;
    fleet.view()->for_each([&](const FleetKey&, const EntryInfo&, const TopologyGraph<>& graph) {
      ++graphs;
      views += graph.views().size();
    });
    CHECK(graphs == 1);
    CHECK(views == (kept ? 1 : 0));
  }
}

TEST_CASE("all that is said of the classes stands in place of their fingerprint", "[fleet]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = warehouse_server();
  FleetOptions options;
  CHECK(followed(conninfo, options).size() == 1);  // any classes
  options.catalog = 78;
  const FleetBag refused = followed(conninfo, options);
  CHECK(refused.size() == 0);
  CHECK(refused.refused().size() == 1);
  options.classes = warehouse();
  CHECK(followed(conninfo, options).size() == 1);
}
