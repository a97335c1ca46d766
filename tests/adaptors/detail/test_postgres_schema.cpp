// SPDX-License-Identifier: MIT
#include <array>
#include <chrono>
#include <string>
#include <vector>

#include <topobag/adaptors/fleet_bag.hpp>
#include <topobag/edges/knn_edges.hpp>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "scratch_folder.hpp"

using namespace topobag;
using detail::PostgresConnection;

namespace {

constexpr auto schema_patience = std::chrono::seconds(30);
const std::string quoted_site = "yard 'O\"Neill'";
const Uuid old_robot{0x52, 0x32}, old_session{0x73};

/// A server as schema 1 left it: in the hall key frames 1 and 2, which moved, and 3, which is
/// erased; in the yard key frame 1.
std::string server_of_schema_1() {
  const std::string base = shared_postgres().new_base();
  const std::string dump = std::string(TOPOBAG_SOURCES) + "/tests/adaptors/fleet_schema_1.sql";
  shared_postgres().sql(content_of(dump), base);
  return base;
}

std::string sql_of(const std::string& base, const std::string& text) {
  return shared_postgres().sql(text, base);
}

/// A version as the robot of that server pushed it.
FleetVersion old_version(const std::string& site, std::uint64_t id, std::int64_t seq, int objects) {
  std::vector<SemanticNode<>> nodes(static_cast<std::size_t>(objects));
  for (int i = 0; i < objects; ++i) {
    auto& node = nodes[static_cast<std::size_t>(i)];
    node.label = ClassId{10 + i};
    node.confidence = 0.5;
    node.size = {0.25, 0.5};
    node.pixel = Eigen::Vector2d(100.0 * i, 50.0);
    node.position = Eigen::Vector3d(i, 0.5 * i * i, 2.0);
    node.z = 2.0;
  }
  EntryInfo info;
  info.stamp = 1.5 * static_cast<double>(id);
  info.label = "frame " + std::to_string(id);
  info.T_world_camera = Eigen::Isometry3d::Identity();
  info.T_world_camera->translation() = Eigen::Vector3d(static_cast<double>(seq), 2.0, -0.5);
  FleetVersion version = version_of({site, old_robot, old_session, KeyframeId{id}}, info,
                                    make_topology_graph(nodes, KnnEdges{3}));
  version.seq = seq;
  version.run = "a walk";
  version.catalog = site == "hall" ? 0 : 77;
  return version;
}

}  // namespace

TEST_CASE("a server of schema 1 is opened, followed and pushed to", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  const std::string base = server_of_schema_1();
  PostgresStore store(base);
  CHECK(error_text([&] {
          store.sites();
        }).find("its fleet's map is of an earlier version of topobag; its owner prepares it") !=
        std::string::npos);
  store.prepare();
  CHECK(store.site_names() == std::vector<std::string>{"hall", quoted_site});
  CHECK(store.sites().at(1).catalog == 77);
  FleetBag fleet({{base, {"hall", quoted_site}}});
  CHECK(fleet.follow() == 6);
  CHECK(fleet.refused().empty());
  REQUIRE(fleet.size() == 3);
  std::vector<FleetKey> keys;
  fleet.view()->for_each([&](const FleetKey& key, const EntryInfo& info, const auto& graph) {
    keys.push_back(key);
    const bool moved = key.site == "hall" && key.keyframe == KeyframeId{2};
    const bool first = key.site == "hall" && key.keyframe == KeyframeId{1};
    CHECK(info.T_world_camera->translation().x() == (moved ? 4.0 : first ? 1.0 : 6.0));
    CHECK(info.stamp == (moved ? 3.0 : 1.5));
    CHECK(info.label == (moved ? "frame 2" : "frame 1"));
    CHECK(graph.size() == (first ? 3 : 4));
    CHECK(graph.nodes().back().label == ClassId{first ? 12 : 13});
  });
  CHECK(keys == std::vector<FleetKey>{{"hall", old_robot, old_session, KeyframeId{1}},
                                      {"hall", old_robot, old_session, KeyframeId{2}},
                                      {quoted_site, old_robot, old_session, KeyframeId{1}}});

  // What is pushed anew is the same to the bit, and what is new arrives.
  CHECK(store.append({old_version("hall", 1, 1, 3), old_version("hall", 2, 4, 4)}) == 0);
  CHECK(store.append({old_version(quoted_site, 1, 6, 4)}) == 0);
  CHECK(store.append({old_version("hall", 9, 7, 5)}) == 1);
  CHECK_THROWS_AS(store.append({old_version("hall", 1, 1, 4)}), InvalidId);
  CHECK(fleet.follow() == 1);
  CHECK(fleet.size() == 4);
  store.add_site("attic", 0);

  // An image may come with what is pushed from now on, and is not asked for of what was.
  FleetVersion with_image = old_version("hall", 1, 1, 3);
  with_image.image = {ImageKind("thumbnail", 3), Eigen::Vector3d(1, 2, 3)};
  CHECK(store.append({with_image}) == 0);
  with_image.seq = 20;
  CHECK(store.append({with_image}) == 1);
  CHECK(fleet.follow() == 1);
  bool seen = false;
  fleet.view()->for_each([&](const FleetKey& key, const EntryInfo& info, const auto&) {
    const bool is_it = key == with_image.key;
    CHECK(info.image == (is_it ? with_image.image : ImageDescriptor()));
    seen = seen || is_it;
  });
  CHECK(seen);

  // Roles have the rights that they had there.
  shared_postgres().sql("CREATE ROLE old_robot LOGIN");
  std::string of_role = base;
  PostgresStore robot(of_role.replace(of_role.find("user=owner"), 10, "user=old_robot"));
  CHECK(robot.append({old_version("hall", 10, 8, 5)}) == 1);
  CHECK_THROWS_AS(robot.append({old_version(quoted_site, 10, 9, 5)}), Error);
  CHECK(robot.site_names() == std::vector<std::string>{"hall", quoted_site});
}

TEST_CASE("a step takes a server to the next schema whole or not at all", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  const std::string base = server_of_schema_1();
  const auto steps_with = [](const char* step) {
    return std::array<const char*, 3>{detail::postgres_migrations[0],
                                      detail::postgres_migrations[1], step};
  };
  const auto made_up = steps_with(
      "ALTER TABLE topobag.site ADD COLUMN owner text;"
      "UPDATE topobag.site SET owner = 'of ' || site");
  const auto failing = steps_with(
      "ALTER TABLE topobag.site ADD COLUMN tenant text;"
      "ALTER TABLE topobag.no_such_table ADD COLUMN tenant text");
  const auto schema = [&] { return sql_of(base, "SELECT schema_version FROM topobag.meta"); };

  PostgresConnection connection(base, schema_patience);
  CHECK_THROWS_AS(detail::migrate_schema(connection, failing), Error);
  CHECK(schema() == "1");
  CHECK_THROWS_AS(sql_of(base, "SELECT tenant FROM topobag.site"), std::runtime_error);
  CHECK_THROWS_AS(detail::require_schema(connection, 3), FormatError);

  detail::migrate_schema(connection, made_up);
  detail::migrate_schema(connection, made_up);  // again changes nothing
  CHECK(schema() == "3");
  detail::require_schema(connection, 3);
  CHECK(sql_of(base, "SELECT owner FROM topobag.site WHERE site = 'hall'") == "of hall");
  CHECK(sql_of(base, "SELECT count(*) FROM topobag.version") == "6");

  // To those who know one step less, that is a later version; an empty data base takes all.
  PostgresStore today(base);
  CHECK(error_text([&] { today.sites(); }).find("later version of topobag (schema 3)") !=
        std::string::npos);
  CHECK_THROWS_AS(today.prepare(), FormatError);
  CHECK(schema() == "3");
  PostgresConnection empty(shared_postgres().new_base(), schema_patience);
  detail::migrate_schema(empty, made_up);
  CHECK(detail::postgres_version(empty) == 3);
}
