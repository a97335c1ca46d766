// SPDX-License-Identifier: MIT
// What the README shows of a map that is kept.
#include <utility>
#include <vector>

#include <topobag/bag/snapshot_file.hpp>
#ifdef TOPOBAG_HAS_SQLITE
#include <topobag/adaptors/sqlite.hpp>
#endif

#include "catch.hpp"
#include "docs/working_folder.hpp"

using namespace topobag;

namespace {

TopologyGraph<> two_objects() {
  std::vector<SemanticNode<>> nodes(2);
  nodes[0].position = Eigen::Vector3d(0, 0, 1);
  nodes[1].position = Eigen::Vector3d(1, 0, 1);
  return TopologyGraph<>(std::move(nodes), EdgeList{});
}

}  // namespace

TEST_CASE("a bag is kept in a file", "[docs]") {
  const WorkingFolder folder;
  const Eigen::Isometry3d T_world_camera(Eigen::Translation3d(1, 2, 3));
  const TopologyGraph<> graph = two_objects();
  BagOfTopologyGraphs<> bag;
  EntryInfo info;  // what is known beside the graph, all of it optional
  info.stamp = 1305031102.2;
  info.T_world_camera = T_world_camera;
  bag.add(KeyframeId{7}, graph, info);
  save(bag, "kitchen.bag");                          // complete under its name, or not at all
  bag = load<BagOfTopologyGraphs<>>("kitchen.bag");  // or a FormatError; `bag` is then as it was
  CHECK(bag.size() == 1);
  REQUIRE(bag.contains(KeyframeId{7}));
  CHECK(bag.info(KeyframeId{7})->stamp == info.stamp);
  CHECK(bag.info(KeyframeId{7})->T_world_camera->isApprox(T_world_camera));
}

#ifdef TOPOBAG_HAS_SQLITE
TEST_CASE("a running map goes on where it was", "[docs]") {
  const WorkingFolder folder;
  const TopologyGraph<> graph = two_objects();
  EntryInfo info;
  {
    SqliteBag<> map("kitchen.db");  // a running map: opened again, it goes on
    info.session = map.begin_session("Monday");
    map.add(KeyframeId{7}, graph, info);
    map.query(graph);
  }
  CHECK(SqliteBag<>("kitchen.db").contains(KeyframeId{7}));
}
#endif
