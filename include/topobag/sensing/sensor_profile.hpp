// SPDX-License-Identifier: MIT
#pragma once

#include <topobag/sensing/node_noise.hpp>

namespace topobag {
inline namespace v0 {

/// What depends on the sensor and on how large a place is: ranges, gates and radii, each once. The
/// options of every step take their defaults from it; `lift_options`, `local_graph_options` and
/// `recognition_options` take them from another one. What is in standard deviations or in shares of
/// an object's size goes with the nodes' covariances, and needs no profile.
struct SensorProfile {
  double min_depth = 0.1;         ///< m; nearer measurements are not believed
  double max_depth = 10.0;        ///< m; nor are farther ones
  double detection_range = 8.0;   ///< m within which detectors usually show what is there
  double sure_range = 5.0;        ///< m within which an object that is not shown counts as missing
  double gate_deviations = 3.0;   ///< σ within which two positions may be one object's
  double gate = 0.40;             ///< m; beyond it they are not, whatever σ says
  double least_tolerance = 0.05;  ///< m that two distances may differ by, whatever σ says
  double min_spread = 0.05;       ///< m; objects nearer to one line leave the pose open
  double pose_resolution = 0.5;   ///< m; poses in one graph further apart are different
  double place_resolution = 1.0;  ///< m; poses in the world further apart are different places
  double place_radius = 2.5;      ///< m around the camera from which key frames are of one place
  double place_margin = 0.5;      ///< m from an object of the query that its place reaches at least
  NodeNoise noise{};              ///< of a measured position

  /// A Kinect or its like in a hand or on a small robot, indoors: the defaults, which all that the
  /// README reports was measured with.
  static SensorProfile hand_held_rgbd() { return {}; }

  /// Stereo with a base line of 10 to 20 cm, through halls and yards. The depth noise is that of a
  /// quarter of a pixel of disparity at 0.12 m and 500 px: 0.25 / (500 · 0.12) m⁻¹ · z².
  static SensorProfile stereo_robot() {
    SensorProfile profile;
    profile.min_depth = 0.3;
    profile.max_depth = 20.0;
    profile.detection_range = 15.0;
    profile.sure_range = 8.0;
    profile.gate = 1.0;
    profile.place_radius = 4.0;
    profile.noise.depth_quadratic = 0.0042;
    return profile;
  }

  /// Racks and pallets seen across aisles by RGB-D or stereo: objects of metres, places that
  /// repeat.
  static SensorProfile warehouse() {
    SensorProfile profile = stereo_robot();
    profile.sure_range = 6.0;
    profile.gate = 0.6;
    profile.place_resolution = 1.5;
    return profile;
  }

  /// Clusters of a LiDAR's points, outdoors: noise of centimetres at any range, centroids that move
  /// with the side that is seen, cars and trees in place of cups.
  static SensorProfile lidar() {
    SensorProfile profile;
    profile.min_depth = 1.0;
    profile.max_depth = 80.0;
    profile.detection_range = 60.0;
    profile.sure_range = 30.0;
    profile.gate = 1.5;
    profile.least_tolerance = 0.2;
    profile.min_spread = 0.5;
    profile.pose_resolution = 2.0;
    profile.place_resolution = 4.0;
    profile.place_radius = 10.0;
    profile.place_margin = 3.0;
    profile.noise.depth_floor = 0.03;
    profile.noise.depth_quadratic = 0.0;
    profile.noise.box_floor = 0.05;
    return profile;
  }
};

/// What options are made for, unless they are told.
inline constexpr SensorProfile default_sensor{};

/// rad; two poses of a camera that turns by more from one to the other are different.
inline constexpr double rotation_resolution = 0.5;

/// m; how far apart two objects lie tells nothing more beyond it: where the similarities' bins and
/// those of a `LayoutPrior` end. In no profile, for a bag is made with its similarity, and layouts
/// that were learnt and saved lie in such bins.
inline constexpr double layout_range = 5.0;

}  // namespace v0
}  // namespace topobag
