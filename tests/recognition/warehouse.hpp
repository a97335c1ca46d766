// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/sensing/node_noise.hpp>

/// How alike the racks of a warehouse are.
struct WarehouseOptions {
  double jitter = 0.03;  ///< m; σ an axis of an object about the middle of its slot
  double filled = 1.0;   ///< share of the slots with an object
  bool gravity = false;  ///< key frames know which way is down, within 1°
};

/// Six parallel aisles of five racks, every rack made from one template of nine slots in four
/// classes: 270 objects when all slots are filled. The world's z is up. A camera at 1.5 m drives
/// through four of the aisles, a loop of 80 m, or through the two others; it looks ahead and to the
/// racks. A rack hides what stands behind it.
class Warehouse {
 public:
  Warehouse(unsigned seed, const WarehouseOptions& options) : options_(options), random_(seed) {
    const std::array<int, 9> labels{39, 56, 58, 56, 73, 39, 58, 39, 73};
    for (int aisle = 0; aisle < aisles; ++aisle) {
      for (int rack = 0; rack < 5; ++rack) {
        for (std::size_t slot = 0; slot < labels.size(); ++slot) {
          const double x = 0.6 + 2.8 * rack + 0.8 * static_cast<double>(slot % 3);
          const double z = 0.4 + 0.8 * static_cast<double>(slot / 3);
          const Eigen::Vector3d middle(x, front_of(aisle) + 0.3, z);
          const Eigen::Vector3d at = middle + normal3(options.jitter);
          if (uniform() < options.filled) objects_.push_back({labels[slot], at, aisle});
        }
      }
    }
  }

  /// Camera poses each 0.5 m round the mapped aisles, another walk every time: some 15 cm and 4°
  /// about the same line.
  std::vector<Eigen::Isometry3d> loop() {
    std::vector<Eigen::Isometry3d> poses;
    const double far = length;
    for (int aisle = 0; aisle < 4; ++aisle) {
      const bool there = aisle % 2 == 0;
      drive(poses, {there ? 0.0 : far, pitch * aisle}, {there ? far : 0.0, pitch * aisle});
      if (aisle == 3) break;
      drive(poses, {there ? far : 0.0, pitch * aisle}, {there ? far : 0.0, pitch * (aisle + 1)});
    }
    drive(poses, {0.0, pitch * 3}, {0.0, 0.0});
    return poses;
  }

  /// The same through the aisles that the loop never enters.
  std::vector<Eigen::Isometry3d> other_aisles() {
    std::vector<Eigen::Isometry3d> poses;
    for (int aisle = 4; aisle < aisles; ++aisle) {
      drive(poses, {0.0, pitch * aisle}, {length, pitch * aisle});
    }
    return poses;
  }

  /// What a camera there detects: nine in ten of the objects that show between 0.5 and 6 m, off by
  /// 1.5 cm and 1.5 % of the depth.
  topobag::TopologyGraph<> seen_from(const Eigen::Isometry3d& T_world_camera) {
    topobag::View<> view;
    view.camera = {525.0, 525.0, 319.5, 239.5, 640, 480};
    std::vector<topobag::SemanticNode<>> nodes;
    for (const Object& object : objects_) {
      const Eigen::Vector3d exact = T_world_camera.inverse() * object.position;
      if (exact.z() < 0.5 || exact.z() > 6.0 || !view.in_field(exact, 0.0, 6.0)) continue;
      if (is_hidden(object, T_world_camera.translation()) || uniform() < 0.1) continue;
      topobag::SemanticNode<> node;
      node.label = topobag::ClassId{object.label};
      node.position = exact * (1.0 + 0.015 * normal()) + normal3(0.015);
      node.z = node.position->z();
      node.pixel = view.camera.project(*node.position);
      const double width = 0.15 + 0.005 * object.label, height = 0.55 - 0.005 * object.label;
      node.size = {width * std::exp(0.05 * normal()), height * std::exp(0.05 * normal())};
      node.covariance = topobag::NodeNoise{}.covariance(*node.position, node.size, false);
      const Eigen::Vector2d box = view.camera.fx / node.z * node.size;
      view.occluders.push_back({topobag::box_around(*node.pixel, box.x(), box.y()), node.z});
      nodes.push_back(std::move(node));
    }
    std::optional<topobag::Gravity<>> gravity;
    const Eigen::Vector3d down = T_world_camera.linear().transpose() * -Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d tilted = (down + normal3(degree)).normalized();
    if (options_.gravity) gravity = topobag::Gravity<>{tilted, degree};
    return topobag::make_topology_graph(std::move(nodes), topobag::KnnEdges{}, {view}, gravity);
  }

 private:
  struct Object {
    int label;
    Eigen::Vector3d position;  // m, world
    int aisle;
  };

  static constexpr int aisles = 6;
  static constexpr double length = 14.0;       // m, of an aisle
  static constexpr double pitch = 4.0;         // m, from aisle to aisle
  static constexpr double degree = 0.0174533;  // rad

  static double front_of(int aisle) { return pitch * aisle + 1.8; }

  /// Whether a rack's back, or another row of racks, is before the object.
  static bool is_hidden(const Object& object, const Eigen::Vector3d& eye) {
    for (int aisle = 0; aisle <= object.aisle; ++aisle) {
      const double back = front_of(aisle) + 0.6;
      if (aisle == object.aisle) return eye.y() > object.position.y();
      if (eye.y() > back) continue;
      const double share = (back - eye.y()) / (object.position.y() - eye.y());
      const double x = eye.x() + share * (object.position.x() - eye.x());
      if (x > 0.0 && x < length) return true;
    }
    return false;
  }

  void drive(std::vector<Eigen::Isometry3d>& poses, const Eigen::Vector2d& from,
             const Eigen::Vector2d& to) {
    const Eigen::Vector2d way = to - from;
    // Across, it looks to the aisles' middle.
    const double ahead = way.x() != 0.0 ? way.x() : 0.5 * length - from.x();
    const double yaw = std::atan2(1.0, ahead > 0.0 ? 1.0 : -1.0);
    for (double gone = 0.0; gone < way.norm() - 0.25; gone += 0.5) {
      const Eigen::Vector2d at = from + way.normalized() * gone;
      const Eigen::Vector3d stands(at.x() + 0.15 * normal(), at.y() + 0.15 * normal(),
                                   1.5 + 0.03 * normal());
      const double turned = yaw + 4.0 * degree * normal();
      Eigen::Matrix3d R;
      R.col(1) = -Eigen::Vector3d::UnitZ();
      R.col(2) = Eigen::Vector3d(std::cos(turned), std::sin(turned), 0.0);
      R.col(0) = R.col(1).cross(R.col(2));
      const Eigen::AngleAxisd roll(degree * normal(), Eigen::Vector3d::UnitZ());
      const Eigen::AngleAxisd tilt(degree * normal(), Eigen::Vector3d::UnitX());
      poses.push_back(Eigen::Translation3d(stands) * Eigen::Quaterniond(R) * roll * tilt);
    }
  }

  double uniform() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }

  /// Nearly normal: the sum of twelve.
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

  Eigen::Vector3d normal3(double deviation) {
    const double x = normal(), y = normal(), z = normal();
    return deviation * Eigen::Vector3d(x, y, z);
  }

  WarehouseOptions options_;
  std::mt19937_64 random_;
  std::vector<Object> objects_;
};
