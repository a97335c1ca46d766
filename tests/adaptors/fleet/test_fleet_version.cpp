// SPDX-License-Identifier: MIT
#include <random>

#include <topobag/adaptors/fleet/fleet_version.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

TEST_CASE("keys are ordered by site, robot, session and number", "[fleet]") {
  const FleetKey least{"hall", Uuid{1}, Uuid{1}, KeyframeId{9}};
  CHECK(least == FleetKey{"hall", Uuid{1}, Uuid{1}, KeyframeId{9}});
  CHECK(least < FleetKey{"yard", Uuid{0}, Uuid{0}, KeyframeId{0}});
  CHECK(least < FleetKey{"hall", Uuid{2}, Uuid{0}, KeyframeId{0}});
  CHECK(least < FleetKey{"hall", Uuid{1}, Uuid{2}, KeyframeId{0}});
  CHECK(least < FleetKey{"hall", Uuid{1}, Uuid{1}, KeyframeId{10}});
}

TEST_CASE("a version says what its key frame does", "[fleet]") {
  std::mt19937 random(1);
  const auto graph = random_graph(random, 6);
  EntryInfo info;
  info.stamp = 3.5;
  info.label = "second floor";
  info.T_world_camera = Eigen::Isometry3d(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  info.T_world_camera->translation() = Eigen::Vector3d(1, 2, 3);
  const FleetVersion version = version_of({"hall", Uuid{1}, Uuid{2}, KeyframeId{3}}, info, graph);
  CHECK(version.graph == encode(graph));
  CHECK_FALSE(version.tombstone);
  const EntryInfo back = version.info();
  CHECK(back.stamp == info.stamp);
  CHECK(back.label == info.label);
  CHECK(back.T_world_camera->isApprox(*info.T_world_camera, 1e-12));
  CHECK_FALSE(version_of({"hall", {}, {}, {}}, {}, graph).info().T_world_camera);
  info.label = "\xFF";
  CHECK_THROWS_AS(version_of({"hall", {}, {}, {}}, info, graph), InvalidValue);
}
