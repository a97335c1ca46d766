// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/lift_clusters.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const ClassCatalog objects = ClassCatalog::coco80();

ObjectCluster cluster_of(const char* name, const Eigen::Vector3d& centroid) {
  ObjectCluster cluster;
  cluster.label = objects.at(name);
  cluster.centroid = centroid;
  cluster.extent = {0.6, 0.8, 1.5};
  return cluster;
}

}  // namespace

TEST_CASE("a cluster is a node at its centroid, in the graph's axes", "[sensing]") {
  ObjectCluster bench = cluster_of("bench", {8.0, 2.0, -0.5}), behind = bench;
  bench.covariance = Eigen::Vector3d(0.04, 0.09, 0.01).asDiagonal();
  behind.centroid.x() = -8.0;
  const auto lifted =
      lift_clusters(std::vector<ObjectCluster>{bench, behind}, T_graph_forward_left_up(), objects);
  REQUIRE(lifted.nodes.size() == 2);
  const SemanticNode<>& node = lifted.nodes[0];
  CHECK_FALSE(node.pixel);
  CHECK(*node.position == Eigen::Vector3d(-2.0, 0.5, 8.0));  // right, down, forward
  CHECK(node.z == 8.0);
  CHECK(node.size.isApprox(Eigen::Vector2d(1.0, 1.5)));
  CHECK(node.covariance.isApprox(
      Eigen::Matrix3d(Eigen::Vector3d(0.09, 0.01, 0.04).asDiagonal())));
  CHECK(lifted.nodes[1].z == 0.0);
  CHECK(lifted.nodes[1].covariance(0, 0) == Approx(std::pow(0.1 + 0.1 * std::sqrt(3.25), 2)));
  CHECK_NOTHROW(TopologyGraph<>(lifted.nodes));
}

TEST_CASE("clusters that are no node are counted by the reason", "[sensing]") {
  std::vector<ObjectCluster> clusters(5, cluster_of("bench", {8.0, 2.0, 0.0}));
  clusters[0].centroid.x() = std::nan("");
  clusters[1].confidence = 0.1;
  clusters[2] = cluster_of("person", {5.0, 0.0, 0.0});
  clusters[3].centroid.x() = 90.0;
  clusters.push_back(clusters[4]);
  const auto lifted = lift_clusters(clusters, T_graph_forward_left_up(), objects);
  CHECK(lifted.sources == std::vector<std::size_t>{4});
  CHECK(lifted.dropped.invalid == 1);
  CHECK(lifted.dropped.low_confidence == 1);
  CHECK(lifted.dropped.dynamic == 1);
  CHECK(lifted.dropped.out_of_range == 1);
  CHECK(lifted.dropped.duplicate == 1);
  clusters[1].label = ClassId{999};
  std::optional<std::size_t> unknown;
  try {
    lift_clusters(clusters, T_graph_forward_left_up(), objects);
  } catch (const UnknownClass& error) {
    unknown = error.index();
  }
  CHECK(unknown == 1U);
  Eigen::Isometry3d scaled = Eigen::Isometry3d::Identity();
  scaled.linear() *= 2.0;
  CHECK_THROWS_AS(lift_clusters({}, scaled, objects), InvalidValue);
}
