// SPDX-License-Identifier: MIT
// What the page bearings.md shows.
#include <random>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/recognition/locate_by_bearings.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

TEST_CASE("a camera without depth finds itself in a map with it", "[docs]") {
  std::mt19937 random(21);
  const PinholeCamera<> camera{500.0, 500.0, 320.0, 240.0, 640, 480};
  const SyntheticRoom room(4, 9, 9);
  BagOfTopologyGraphs<> map;
  std::vector<Eigen::Isometry3d> cameras;
  for (unsigned i = 0; i < 3; ++i) {
    cameras.push_back(random_camera(random));
    map.add(KeyframeId{i}, room.seen_from(cameras[i]), standing_at(cameras[i]));
  }
  const Eigen::Isometry3d T_room_camera = random_camera(random);
  std::vector<Detection> detections;
  const int tidy[] = {56, 57, 58, 59, 60, 61, 62, 63, 64};  // chairs to mice: they stand still
  std::vector<ClassId> classes;
  for (const int label : tidy) classes.push_back(ClassId{label});
  BagOfTopologyGraphs<> furnished;
  map.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    std::vector<SemanticNode<>> nodes = graph.nodes();
    for (auto& node : nodes) node.label = classes[static_cast<std::size_t>(value(node.label))];
    furnished.add(id, TopologyGraph<>(std::move(nodes)), info);
  });
  map = furnished;
  const auto in_sight = room.seen_from(T_room_camera);
  for (const auto& node : in_sight.nodes()) {
    const Eigen::Vector2d size = 500.0 / node.z * node.size;
    detections.push_back({box_around(*camera.project(*node.position), size.x(), size.y()),
                          classes[static_cast<std::size_t>(value(node.label))]});
  }
  std::size_t used = 0;
  const auto use = [&](KeyframeId id, const PoseWithCovariance<>& T_candidate_query) {
    ++used;
    const Eigen::Isometry3d T = *map.info(id)->T_world_camera * T_candidate_query.T;
    CHECK((T.translation() - T_room_camera.translation()).norm() < 0.1);
    CHECK(T_candidate_query.covariance.diagonal().minCoeff() > 0.0);
  };
  const BearingSighting seen = sight_bearings(detections, camera, ClassCatalog::coco80());
  const Recognition found =
      locate_by_bearings(map, seen, recognition_options(ClassCatalog::coco80()));
  if (found) use(found.accepted->id, found.accepted->pose->with_covariance());
  CHECK(used == 1);
}
