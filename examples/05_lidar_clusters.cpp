// SPDX-License-Identifier: MIT
// A LiDAR front end: clusters of points in, the pose in the map out. No camera, no boxes.
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/sensing/lift_clusters.hpp>

using namespace topobag;

namespace {
const char* const names[] = {"pole", "trunk", "bin", "hydrant", "car"};
const ClassCatalog catalog = [] {
  ClassCatalog classes;
  for (int i = 0; i < 5; ++i)
    classes.add(ClassId{i}, names[i], i == 4 ? Dynamics::high : Dynamics::low);
  return classes;
}();
struct Thing {
  ClassId label;
  Eigen::Vector3d place, extent;  // m, in the world: x east, y north, z up
};

std::vector<Thing> street() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> east(-25.0, 25.0), north(-18.0, 18.0), size(0.3, 1.2);
  std::vector<Thing> things;
  for (int i = 0; i < 24; ++i) {
    const Eigen::Vector3d extent(size(random), size(random), 2.0 * size(random));
    things.push_back({ClassId{i % 5}, {east(random), north(random), 0.5 * extent.z()}, extent});
  }
  return things;
}

/// What the segmentation of one scan gives, in the sensor's frame: x forward, y left, z up.
std::vector<ObjectCluster> scan(const Eigen::Isometry3d& T_world_sensor, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, 0.03);
  std::vector<ObjectCluster> clusters;
  for (const Thing& thing : street()) {
    ObjectCluster cluster;
    cluster.label = thing.label;
    cluster.centroid = T_world_sensor.inverse() * thing.place +
                       Eigen::Vector3d(noise(random), noise(random), noise(random));
    cluster.extent = thing.extent;
    cluster.covariance = 0.05 * 0.05 * Eigen::Matrix3d::Identity();
    if (cluster.centroid.norm() < 30.0) clusters.push_back(cluster);
  }
  return clusters;
}

TopologyGraph<> graph_of(const std::vector<ObjectCluster>& clusters) {
  const Gravity<> level{{0.0, 1.0, 0.0}, 0.01};  // the vehicle's IMU says so
  return make_topology_graph(lift_clusters(clusters, T_graph_forward_left_up(), catalog).nodes,
                             KnnEdges{}, {}, level);
}
}  // namespace

int main() {
  std::mt19937 random(7);
  Relocalizer<> relocalizer(recognition_options(catalog, SensorProfile::lidar()));
  for (unsigned i = 0; i < 5; ++i) {
    EntryInfo info;  // the pose is the graph's: of its frame, not of the sensor's
    const Eigen::Isometry3d T_world_sensor(Eigen::Translation3d(4.0 * i - 8.0, 0.0, 1.7));
    info.T_world_camera = T_world_sensor * T_graph_forward_left_up().inverse();
    relocalizer.map().add(KeyframeId{i}, graph_of(scan(T_world_sensor, random)), info);
  }
  const Eigen::Isometry3d truth = Eigen::Translation3d(1.0, 1.5, 1.7) *
                                  Eigen::Isometry3d(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  const Recognition found = relocalizer.localize(graph_of(scan(truth, random)));
  const auto T_world_graph = relocalizer.T_world_query(found);
  if (!T_world_graph) return EXIT_FAILURE;
  const double error =
      (T_world_graph->T * T_graph_forward_left_up() * truth.inverse()).translation().norm();
  std::cout << "found, off by " << error << " m\n";
  return error < 0.2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
