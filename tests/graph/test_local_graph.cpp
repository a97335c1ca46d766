// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/edges/radius_edges.hpp>
#include <topobag/graph/local_graph.hpp>

#include "catch.hpp"
#include "graph/flickering_scene.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

/// The fused object nearest to a point, if it is within 0.1 m.
std::optional<ObjectId> object_near(const LocalGraph<>& local, const Eigen::Vector3d& point,
                                    ClassId label) {
  for (const auto& [id, node] : local.objects()) {
    if (node.label == label && (*node.position - point).norm() < 0.1) return id;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("flicker and false boxes go, objects keep their ids while the window slides", "[graph]") {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    FlickeringScene scene(seed);
    const auto things = FlickeringScene::things();
    LocalGraph<> local;
    std::vector<std::optional<ObjectId>> ids(things.size());
    for (std::size_t frame = 0; frame < FlickeringScene::frames; ++frame) {
      local.add(0.1 * static_cast<double>(frame), scene.nodes(frame),
                FlickeringScene::T_previous_current(frame), camera_view());
      if (frame < 15) continue;
      INFO("seed " << seed << ", frame " << frame);
      REQUIRE(local.objects().size() == things.size());
      for (std::size_t i = 0; i < things.size(); ++i) {
        const Eigen::Vector3d there =
            FlickeringScene::T_world_camera(frame).inverse() * *things[i].position;
        const auto id = object_near(local, there, things[i].label);
        REQUIRE(id);
        if (frame == 15) ids[i] = id;
        CHECK(id == ids[i]);
      }
    }
    CHECK(local.view_count() <= 31);
  }
}

TEST_CASE("fused positions are nearer the truth than single ones", "[graph]") {
  FlickeringScene scene(9);
  LocalGraph<> local;
  const std::size_t last = FlickeringScene::frames - 1;
  for (std::size_t frame = 0; frame <= last; ++frame) {
    local.add(0.1 * static_cast<double>(frame), scene.nodes(frame),
              FlickeringScene::T_previous_current(frame), camera_view());
  }
  const auto things = FlickeringScene::things();
  const auto objects = local.objects();
  REQUIRE(objects.size() == things.size());
  for (const auto& thing : things) {
    const Eigen::Vector3d there = FlickeringScene::T_world_camera(last).inverse() * *thing.position;
    double nearest = 1.0;
    for (const auto& [id, node] : objects) {
      nearest = std::min(nearest, (*node.position - there).norm());
    }
    CHECK(nearest < 0.02);  // one sighting is 0.035 m off, r.m.s.
  }
}

TEST_CASE("two boxes on one thing are one object", "[graph]") {
  LocalGraph<> local;
  for (int frame = 0; frame < 5; ++frame) {
    SemanticNode<> laptop = object_at(2, {0.02, 0, 2});
    laptop.confidence = 0.4;
    local.add(0.1 * frame, {object_at(1, {0, 0, 2}), laptop}, still, camera_view());
    const auto objects = local.objects();
    REQUIRE(objects.size() == 1);
    CHECK(objects[0].first == ObjectId{0});
    CHECK(objects[0].second.label == ClassId{1});
    CHECK(objects[0].second.existence == 1.0);
  }
}

TEST_CASE("an object keeps its id when the detector wavers between classes", "[graph]") {
  LocalGraph<> local;
  for (int frame = 0; frame < 9; ++frame) {
    local.add(0.1 * frame, {object_at(frame % 3 == 1 ? 2 : 1, {0, 0, 2})}, still, camera_view());
    REQUIRE(local.objects().size() == 1);
    CHECK(local.objects()[0].first == ObjectId{0});
  }
  CHECK(local.objects()[0].second.label == ClassId{1});
}

TEST_CASE("neighbours of one class that a view shows together stay two", "[graph]") {
  LocalGraph<> local;
  for (int frame = 0; frame < 9; ++frame) {
    local.add(0.1 * frame, {object_at(1, {0, 0, 2}), object_at(1, {0.3, 0, 2})}, still,
              camera_view());
    CHECK(local.objects().size() == 2);
  }
}

TEST_CASE("the window forgets, and no id comes again", "[graph]") {
  LocalGraph<> local;
  local.add(0.0, {object_at(1, {0, 0, 2})}, still);
  local.add(3.0, {}, still);
  REQUIRE(local.objects().size() == 1);
  CHECK(local.view_count() == 2);
  local.add(3.1, {}, still);
  CHECK(local.objects().empty());
  CHECK(local.view_count() == 2);
  local.add(3.2, {object_at(1, {0, 0, 2})}, still);
  REQUIRE(local.objects().size() == 1);
  CHECK(local.objects()[0].first == ObjectId{1});
  local.add(100.0, {}, still);
  CHECK(local.view_count() == 1);
  CHECK(local.graph().empty());
}

TEST_CASE("existence is the share of the views due that saw the object", "[graph]") {
  const SemanticNode<> object = object_at(1, {0, 0, 3});
  const auto existence_after = [&](const View<>& without) {
    LocalGraph<> local;
    local.add(0.0, {object}, still, camera_view());
    local.add(0.1, {object}, still, camera_view());
    for (int frame = 2; frame < 5; ++frame) local.add(0.1 * frame, {}, still, without);
    return local.objects().at(0).second.existence;
  };
  View<> hidden = camera_view(), blind;
  hidden.occluders.push_back({{300, 220, 340, 260}, 1.0});
  CHECK(existence_after(camera_view()) == Approx(0.4));
  CHECK(existence_after(hidden) == 1.0);
  CHECK(existence_after(blind) == 1.0);

  LocalGraph<> local;
  local.add(0.0, {object}, still, camera_view());
  for (int frame = 1; frame < 5; ++frame) local.add(0.1 * frame, {}, still, camera_view());
  CHECK(local.objects().size() == 1);  // one of five
  local.add(0.5, {}, still, camera_view());
  CHECK(local.objects().empty());  // one of six
}

TEST_CASE("everything is in the newest camera's frame", "[graph]") {
  std::mt19937 random(3);
  LocalGraph<> local;
  SemanticNode<> node = object_at(1, {0.3, -0.2, 3});
  node.covariance = random_covariance(random, 0.05);
  local.add(0.0, {node}, still, camera_view());
  Eigen::Isometry3d T_first_newest = still;
  for (int frame = 1; frame < 6; ++frame) {
    const Eigen::Isometry3d step = random_motion(random, 0.5);
    T_first_newest = T_first_newest * step;
    local.add(0.1 * frame, {}, step, View<>{});
    const auto objects = local.objects();
    REQUIRE(objects.size() == 1);
    const SemanticNode<>& fused = objects[0].second;
    const Eigen::Matrix3d R = T_first_newest.linear().transpose();
    const Eigen::Vector3d there = T_first_newest.inverse() * *node.position;
    CHECK(fused.position->isApprox(there, 1e-9));
    CHECK(fused.covariance.isApprox(R * node.covariance * R.transpose(), 1e-9));
    CHECK(fused.z == Approx(std::max(0.0, there.z())));
    const TopologyGraph<> graph = local.graph();
    REQUIRE(graph.views().size() == local.view_count());
    CHECK(graph.views().front().T_graph_camera.isApprox(T_first_newest.inverse(), 1e-9));
    CHECK(graph.views().back().T_graph_camera.matrix().isIdentity());
  }
}

TEST_CASE("an object behind the newest camera has no pixel", "[graph]") {
  LocalGraph<> local;
  local.add(0.0, {object_at(1, {0, 0, 2})}, still, camera_view());
  REQUIRE(local.objects().at(0).second.pixel);
  CHECK(local.objects()[0].second.pixel->isApprox(Eigen::Vector2d(319.5, 239.5)));
  local.add(0.1, {}, Eigen::Isometry3d(Eigen::Translation3d(0, 0, 3)), camera_view());
  CHECK_FALSE(local.objects().at(0).second.pixel);
  CHECK(local.objects()[0].second.z == 0.0);
}

TEST_CASE("the graph holds the objects, joined by the builder", "[graph]") {
  LocalGraph<> local;
  local.add(0.0, FlickeringScene::things(), still, camera_view());
  const TopologyGraph<> graph = local.graph(RadiusEdges{1.0});
  const auto objects = local.objects();
  REQUIRE(graph.size() == objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    CHECK(graph.nodes()[i].position == objects[i].second.position);
    CHECK((i == 0 || objects[i - 1].first < objects[i].first));
  }
  CHECK(graph.edges() == RadiusEdges{1.0}(graph.nodes()));
  CHECK(local.graph().edges() == KnnEdges{}(graph.nodes()));
}

TEST_CASE("a node whose covariance is not modelled gets the default noise", "[graph]") {
  LocalGraph<> local;
  SemanticNode<> node = object_at(1, {0.5, 0, 2}), unplaced;
  node.covariance.setZero();
  local.add(0.0, {unplaced, node}, still);
  REQUIRE(local.objects().size() == 1);
  CHECK(local.objects()[0].second.covariance.isApprox(
      NodeNoise{}.covariance(*node.position, node.size, false), 1e-9));
}

TEST_CASE("a sighting is added as its parts are", "[graph]") {
  FlickeringScene scene(4);
  LocalGraph<> by_parts, whole;
  for (std::size_t frame = 0; frame < 10; ++frame) {
    KeyframeSighting seen;
    seen.stamp = 0.1 * static_cast<double>(frame);
    seen.nodes = scene.nodes(frame);
    seen.view = camera_view();
    seen.gravity = Gravity<>{};
    const Eigen::Isometry3d T_previous_current = FlickeringScene::T_previous_current(frame);
    by_parts.add(seen.stamp, seen.nodes, T_previous_current, seen.view, seen.gravity);
    whole.add(seen, T_previous_current);
  }
  const TopologyGraph<> a = by_parts.graph(), b = whole.graph();
  REQUIRE(a.size() == b.size());
  REQUIRE(!a.empty());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(*a.nodes()[i].position == *b.nodes()[i].position);
  REQUIRE(b.gravity());
  CHECK(a.gravity()->down == b.gravity()->down);
  CHECK(a.views().size() == b.views().size());
}

TEST_CASE("the cameras of a rig make one graph of one stamp", "[graph]") {
  // Two cameras side by side on a rig, 0.3 m apart, the right one turned outwards by 40°: each sees
  // things that the other cannot, and one that both do.
  Eigen::Isometry3d T_left_right(Eigen::AngleAxisd(40.0 * 3.14159265 / 180.0,
                                                   Eigen::Vector3d::UnitY()));
  T_left_right.translation() = Eigen::Vector3d(0.3, 0.0, 0.0);
  const std::vector<Eigen::Vector3d> things{{-0.8, 0.1, 2.5}, {0.9, 0.0, 2.5}, {3.0, 0.2, 2.5}};
  const auto seen_by = [&](const Eigen::Isometry3d& T_left_camera, double along, double stamp) {
    KeyframeSighting seen;
    seen.stamp = stamp;
    seen.view = camera_view();
    for (std::size_t i = 0; i < things.size(); ++i) {
      SemanticNode<> node;
      node.label = ClassId{static_cast<std::int32_t>(i)};
      node.position =
          T_left_camera.inverse() * Eigen::Vector3d(things[i] - along * Eigen::Vector3d::UnitX());
      node.size = {0.3, 0.3};
      if (seen.view.in_field(*node.position, 0.0, 5.0)) seen.nodes.push_back(node);
    }
    return seen;
  };
  const Eigen::Isometry3d T_left_left = Eigen::Isometry3d::Identity();
  LocalGraphOptions options;
  options.window = GENERATE(0.0, 3.0);
  LocalGraph<> local(options);
  for (int i = 0; i < 4; ++i) {
    const double along = 0.1 * i, stamp = 0.5 * i;
    // From the left camera of this stamp to the right one of the stamp before.
    const Eigen::Isometry3d motion(Eigen::Translation3d(i == 0 ? 0.0 : 0.1, 0.0, 0.0));
    local.add(seen_by(T_left_left, along, stamp), T_left_right.inverse() * motion);
    local.add(seen_by(T_left_right, along, stamp), T_left_right);
  }
  const TopologyGraph<> graph = local.graph();
  CHECK(graph.views().size() == (options.window > 0.0 ? 8U : 2U));
  REQUIRE(graph.size() == things.size());  // what both see is one object
  for (const auto& node : graph.nodes()) {
    const Eigen::Vector3d there = things[static_cast<std::size_t>(value(node.label))] -
                                  0.3 * Eigen::Vector3d::UnitX();
    CHECK((T_left_right * *node.position - there).norm() < 1e-9);  // in the right camera's frame
    CHECK(node.existence == 1.0);  // who cannot see it need not have
  }
}
