// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <topobag/graph/topology_graph.hpp>

#include "random_graphs.hpp"

/// An object of 0.2 m × 0.2 m known to `deviation` m along each axis.
inline topobag::SemanticNode<> object_at(int label, const Eigen::Vector3d& position,
                                         double deviation = 0.02) {
  topobag::SemanticNode<> node;
  node.label = topobag::ClassId{label};
  node.position = position;
  node.z = position.z();
  node.size = {0.2, 0.2};
  node.covariance = deviation * deviation * Eigen::Matrix3d::Identity();
  return node;
}

/// A random symmetric positive definite matrix with standard deviations of about `scale`.
inline Eigen::Matrix3d random_covariance(std::mt19937& random, double scale) {
  std::normal_distribution<double> normal;
  Eigen::Matrix3d root;
  for (Eigen::Index i = 0; i < 9; ++i) root(i) = normal(random);
  const Eigen::Matrix3d square = root * root.transpose() + 0.1 * Eigen::Matrix3d::Identity();
  return scale * scale / 3.0 * square;
}

/// `random_nodes` with covariances, in a graph without edges, which the matching does not read.
inline topobag::TopologyGraph<> noisy_graph(std::mt19937& random, std::size_t count, int classes,
                                            double deviation = 0.04) {
  auto nodes = random_nodes(random, count, classes);
  for (auto& node : nodes) node.covariance = random_covariance(random, deviation);
  return topobag::TopologyGraph<>(std::move(nodes));
}

/// Objects of one class in rows of `columns`.
inline topobag::TopologyGraph<> grid_graph(std::size_t count, std::size_t columns, double spacing) {
  std::vector<topobag::SemanticNode<>> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = static_cast<double>(i % columns), row = static_cast<double>(i / columns);
    nodes.push_back(object_at(1, {spacing * column, spacing * row, 3.0}));
  }
  return topobag::TopologyGraph<>(std::move(nodes));
}

/// The same graph, each position off by `scale` times noise of its own covariance.
inline topobag::TopologyGraph<> jittered(std::mt19937& random,
                                         const topobag::TopologyGraph<>& graph, double scale) {
  std::normal_distribution<double> normal;
  auto nodes = graph.nodes();
  for (auto& node : nodes) {
    const double x = normal(random), y = normal(random), z = normal(random);
    const Eigen::Vector3d drawn = scale * Eigen::Vector3d(x, y, z);
    *node.position += node.covariance.llt().matrixL() * drawn;
  }
  return topobag::TopologyGraph<>(std::move(nodes), graph.edges());
}

/// Any rotation, and a translation of at most `metres` along each axis.
inline Eigen::Isometry3d random_motion(std::mt19937& random, double metres) {
  std::uniform_real_distribution<double> along(-metres, metres);
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(w, x, y, z).normalized();
  const double a = along(random), b = along(random), c = along(random);
  return Eigen::Translation3d(a, b, c) * rotation;
}

/// The angle of the rotation between the two.
inline double angle_between(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

/// The same objects in another frame.
inline topobag::TopologyGraph<> moved(const topobag::TopologyGraph<>& graph,
                                      const Eigen::Isometry3d& T_new_old) {
  const Eigen::Matrix3d R = T_new_old.linear();
  auto nodes = graph.nodes();
  for (auto& node : nodes) {
    node.position = T_new_old * *node.position;
    node.covariance = (R * node.covariance * R.transpose()).eval();
  }
  return topobag::TopologyGraph<>(std::move(nodes), graph.edges(), graph.views());
}

/// The mirror image in the plane x = 0.
inline topobag::TopologyGraph<> mirrored(const topobag::TopologyGraph<>& graph) {
  auto nodes = graph.nodes();
  for (auto& node : nodes) node.position->x() *= -1.0;
  return topobag::TopologyGraph<>(std::move(nodes), graph.edges());
}
