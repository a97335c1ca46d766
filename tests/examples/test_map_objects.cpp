// SPDX-License-Identifier: MIT
#include "view/map_objects.hpp"

#include <utility>
#include <vector>

#include "catch.hpp"
#include "likely_up.hpp"

namespace {

using program::Keyframe;
using program::map_objects;

/// A class and where an object of it is in the world, m.
struct Placed {
  int label = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

/// A key frame that sees the objects from a camera, each 0.2 m large and known to 0.05 m.
Keyframe seeing(const std::vector<Placed>& objects, const Eigen::Isometry3d& T_world_camera) {
  std::vector<topobag::SemanticNode<>> nodes;
  for (const Placed& object : objects) {
    topobag::SemanticNode<> node;
    node.label = topobag::ClassId{object.label};
    node.position = T_world_camera.inverse() * object.place;
    node.covariance = 0.0025 * Eigen::Matrix3d::Identity();
    node.size = {0.2, 0.2};
    nodes.push_back(node);
  }
  Keyframe keyframe;
  keyframe.T_world_camera = T_world_camera;
  keyframe.graph = topobag::TopologyGraph<>(std::move(nodes));
  return keyframe;
}

Eigen::Isometry3d camera_at(double x, double turn) {
  return Eigen::Translation3d(x, 0, 0) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY());
}

const topobag::ClassGroups no_lookalikes;

}  // namespace

TEST_CASE("an object seen from two places is one of the map's", "[examples]") {
  const std::vector<Placed> objects{{1, {0, 0, 2}}, {2, {1, 0, 3}}};
  const auto map = map_objects(
      {seeing(objects, camera_at(0, 0)), seeing(objects, camera_at(0.7, 0.4))}, no_lookalikes);
  REQUIRE(map.objects.size() == 2);
  CHECK(map.of_nodes[0] == map.of_nodes[1]);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK((map.objects[i].position - objects[i].place).norm() < 1e-9);
    CHECK(map.objects[i].size.isApprox(Eigen::Vector2d(0.2, 0.2)));
    CHECK(map.objects[i].keyframes == std::vector<std::size_t>{0, 1});
    CHECK(map.objects[i].sight.norm() <= 1.0 + 1e-9);
  }
}

TEST_CASE("objects apart, or of classes apart, stay apart", "[examples]") {
  const auto count = [](const Placed& first, const Placed& second,
                        const topobag::ClassGroups& classes) {
    return map_objects({seeing({first}, camera_at(0, 0)), seeing({second}, camera_at(0, 0.1))},
                       classes)
        .objects.size();
  };
  const Placed cup{1, {0, 0, 2}};
  CHECK(count(cup, {1, {0.05, 0, 2}}, no_lookalikes) == 1);
  CHECK(count(cup, {1, {0.5, 0, 2}}, no_lookalikes) == 2);
  CHECK(count(cup, {1, {0, 0, 4}}, no_lookalikes) == 2);
  CHECK(count(cup, {3, {0, 0, 2}}, no_lookalikes) == 2);
  topobag::ClassGroups lookalikes;
  lookalikes.join(topobag::ClassId{1}, topobag::ClassId{3});
  CHECK(count(cup, {3, {0, 0, 2}}, lookalikes) == 1);
}

TEST_CASE("two nodes of one key frame are two objects, the nearest joined first", "[examples]") {
  const std::vector<Placed> two{{1, {0, 0, 2}}, {1, {0.1, 0, 2}}};
  const auto map = map_objects(
      {seeing(two, camera_at(0, 0)), seeing({two[1], two[0]}, camera_at(0.2, 0))}, no_lookalikes);
  CHECK(map.objects.size() == 2);
  CHECK(map.of_nodes[1][0] == map.of_nodes[0][1]);
  CHECK(map.of_nodes[1][1] == map.of_nodes[0][0]);
}

TEST_CASE("a key frame without a pose has no objects in the world", "[examples]") {
  Keyframe lost = seeing({{1, {0, 0, 2}}}, camera_at(0, 0));
  lost.T_world_camera.reset();
  const auto map = map_objects({lost}, no_lookalikes);
  CHECK(map.objects.empty());
  REQUIRE(map.of_nodes.size() == 1);
  CHECK_FALSE(map.of_nodes[0][0]);
}

TEST_CASE("up is the axis that most cameras' tops point along", "[examples]") {
  const Eigen::Isometry3d level = Eigen::Isometry3d::Identity();
  CHECK(program::likely_up({level}) == -Eigen::Vector3d::UnitY());
  const Eigen::Isometry3d upright(Eigen::AngleAxisd(-1.2, Eigen::Vector3d::UnitX()));
  CHECK(program::likely_up({upright}) == Eigen::Vector3d::UnitZ());
  CHECK(program::likely_up({upright, upright, level}) == Eigen::Vector3d::UnitZ());
}
