// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/same_object.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/class_catalog.hpp>
#include <topobag/types/dynamics.hpp>
#include <topobag/types/ids.hpp>
#include <topobag/types/rigid_motion.hpp>
#include <topobag/types/semantic_node.hpp>

namespace topobag {
inline namespace v0 {

/// Points that are one object: what a front end without boxes and camera has of it, such as a
/// LiDAR's.
struct ObjectCluster {
  ClassId label{};                                     ///< class, numbered as in the catalog in use
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< m, in the sensor's frame
  Eigen::Vector3d extent = Eigen::Vector3d::Zero();    ///< m, along the sensor's axes; 0 = unknown
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the centroid, m²; zero = not known
  double confidence = 1.0;                               ///< classifier's score in [0, 1]
};

/// Which clusters become nodes.
struct ClusterOptions {
  DynamicsSet keep{Dynamics::low, Dynamics::medium};  ///< dynamic filter: levels that are kept
  double min_confidence = 0.3;                        ///< classifier's score
  double max_range = SensorProfile::lidar().max_depth;  ///< m from the sensor
  SameObject duplicate{};       ///< of two nodes that are one object the surer one is kept
  double centroid_floor = 0.1;  ///< m; σ of a centroid whose covariance is not known
  double centroid_share = 0.1;  ///< of the extent, added to it: another side shows other points
};

/// A sensor that looks along x, with y to the left and z up (ROS's REP 103), in the axes of a graph:
/// x right, y down, z forward.
inline Eigen::Isometry3d T_graph_forward_left_up() {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << 0.0, -1.0, 0.0,  //
      0.0, 0.0, -1.0,            //
      1.0, 0.0, 0.0;
  return T;
}

/// Turns clusters into semantic nodes: no pixel, the centroid as the position, and as the size the
/// diagonal of the ground that the object covers and its height. No view comes with them, so what is
/// missing speaks against nothing. Join them by an edge builder of positions: `KnnEdges`.
///
/// @param clusters        a range of `ObjectCluster`
/// @param T_graph_sensor  from the sensor's frame to the graph's: `T_graph_forward_left_up()` where
///                        the sensor is level
/// @param catalog         the classes that the labels number
/// Throws UnknownClass with the cluster's index, InvalidValue for a pose that is no rigid motion.
/// What is not finite is counted as invalid. O(n · kept).
template <typename Clusters = std::vector<ObjectCluster>>
LiftedNodes<double> lift_clusters(const Clusters& clusters, const Eigen::Isometry3d& T_graph_sensor,
                                  const ClassCatalog& catalog, const ClusterOptions& options = {}) {
  require_rigid(T_graph_sensor, "the sensor's pose");
  const Eigen::Matrix3d R = T_graph_sensor.linear();
  LiftedNodes<double> lifted;
  std::size_t index = 0;
  for (const ObjectCluster& cluster : clusters) {
    const std::size_t source = index++;
    detail::require_known(catalog, cluster.label, source);
    if (!cluster.centroid.allFinite() || !cluster.extent.allFinite() ||
        !cluster.covariance.allFinite() || !std::isfinite(cluster.confidence)) {
      ++lifted.dropped.invalid;
    } else if (cluster.confidence < options.min_confidence) {
      ++lifted.dropped.low_confidence;
    } else if (!options.keep.contains(catalog.dynamics(cluster.label))) {
      ++lifted.dropped.dynamic;
    } else if (cluster.centroid.norm() > options.max_range) {
      ++lifted.dropped.out_of_range;
    } else {
      const Eigen::Vector3d extent = R.cwiseAbs() * cluster.extent.cwiseAbs();
      SemanticNode<> node;
      node.label = cluster.label;
      node.position = T_graph_sensor * cluster.centroid;
      node.z = std::max(node.position->z(), 0.0);
      node.size = {std::hypot(extent.x(), extent.z()), extent.y()};
      const double deviation = options.centroid_floor + options.centroid_share * extent.norm();
      node.covariance = cluster.covariance.isZero(0.0)
                            ? Eigen::Matrix3d(deviation * deviation * Eigen::Matrix3d::Identity())
                            : Eigen::Matrix3d(R * cluster.covariance * R.transpose());
      node.confidence = cluster.confidence;
      lifted.nodes.push_back(std::move(node));
      lifted.sources.push_back(source);
    }
  }
  detail::drop_duplicates(lifted, options.duplicate);
  return lifted;
}

}  // namespace v0
}  // namespace topobag
