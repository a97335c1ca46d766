// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <topobag/matching/point_pair.hpp>
#include <topobag/sensing/node_noise.hpp>
#include <topobag/sensing/pinhole_camera.hpp>
#include <topobag/types/ranged_detection.hpp>

#include "draws.hpp"

namespace bench {

/// How the features of two images are made up.
struct FeatureSimulation {
  std::size_t features = 1000;       ///< of the first image, evenly spread over it
  double nearest_person = 1.0;       ///< m; depths of people are drawn evenly
  double furthest_person = 2.5;      ///< m
  double nearest_background = 1.5;   ///< m; depths of all else are drawn evenly, each by itself
  double furthest_background = 4.5;  ///< m
  double speed = 1.2;                ///< m/s; a person walks level, at up to this, drawn evenly
  double limbs = 0.2;                ///< m/s along each axis, one σ: of a point against its person
  double pixel = 1.0;                ///< px along each axis, one σ; depths have `NodeNoise`'s
  double missed = 0.0;               ///< share of people of whom the detector tells nothing
};

/// A feature that both images show.
struct SimulatedFeature {
  Eigen::Vector2d pixel;    ///< in the first image, as measured
  double z = 0.0;           ///< m, likewise
  bool on_person = false;   ///< so it moves by itself
  topobag::PointPair pair;  ///< target: the first camera's frame, source: the second's
};

/// Two images' features and what a detector says of the first.
struct SimulatedFeatures {
  std::vector<SimulatedFeature> features;        ///< those in both images
  std::vector<topobag::RangedDetection> people;  ///< with depth, but for those missed
  double covered = 0.0;  ///< share of the first image's features that lie on people
};

namespace detail {

/// One standard deviation of a depth, m: the sensor's part of `NodeNoise`.
inline double depth_noise(double z) {
  const topobag::NodeNoise noise;
  return std::hypot(noise.depth_floor, noise.depth_quadratic * z * z);
}

/// A point as one camera measures it.
struct MeasuredPoint {
  MeasuredPoint(const Eigen::Vector2d& true_pixel, double true_z,
                const topobag::PinholeCamera<>& camera, double pixel_noise, program::Draws& draws)
      : pixel(true_pixel + pixel_noise * Eigen::Vector2d(draws.normal(), draws.normal())),
        z(true_z + depth_noise(true_z) * draws.normal()),
        position(camera.back_project(pixel, z)) {
    topobag::NodeNoise noise;
    noise.box_floor = pixel_noise * z / camera.fx;
    covariance = noise.covariance(position, Eigen::Vector2d(0.0, 0.0), false);
  }

  Eigen::Vector2d pixel;
  double z;                  // m
  Eigen::Vector3d position;  // m, camera frame
  Eigen::Matrix3d covariance;
};

/// A person who fills the ellipse within the box, all at one depth.
struct SimulatedPerson {
  topobag::BoundingBox box;
  double z;                  // m
  Eigen::Vector3d velocity;  // m/s, world

  bool covers(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d off = pixel - box.center();
    return std::hypot(off.x() / box.width(), off.y() / box.height()) <= 0.5;
  }
};

}  // namespace detail

/// Makes up features of two images, `seconds` apart.
///
/// People fill the ellipse within each of the boxes, walk level (the world's z is up) and are no
/// rigid bodies; all else stands still. No match is wrong, and nothing hides anything in the second
/// image.
/// @param people   the boxes of people in the first image; a depth in them is not read
/// @param T_world_first,T_world_second  of the cameras
inline SimulatedFeatures simulate_features(const std::vector<topobag::RangedDetection>& people,
                                           const topobag::PinholeCamera<>& camera,
                                           const Eigen::Isometry3d& T_world_first,
                                           const Eigen::Isometry3d& T_world_second, double seconds,
                                           const FeatureSimulation& simulation,
                                           program::Draws& draws) {
  const auto between = [&draws](double least, double most) {
    return least + (most - least) * draws.uniform();
  };
  SimulatedFeatures made;
  std::vector<detail::SimulatedPerson> persons;
  for (topobag::RangedDetection person : people) {
    const double z = between(simulation.nearest_person, simulation.furthest_person);
    const double heading = between(-3.141592653589793, 3.141592653589793);
    const double speed = between(0.0, simulation.speed);
    persons.push_back(
        {person.box, z, speed * Eigen::Vector3d(std::cos(heading), std::sin(heading), 0.0)});
    person.z = z + detail::depth_noise(z) * draws.normal();
    if (draws.uniform() >= simulation.missed) made.people.push_back(person);
  }
  std::size_t on_people = 0;
  for (std::size_t i = 0; i < simulation.features; ++i) {
    const Eigen::Vector2d pixel(between(0.0, camera.width - 1.0),
                                between(0.0, camera.height - 1.0));
    double z = between(simulation.nearest_background, simulation.furthest_background);
    const detail::SimulatedPerson* owner = nullptr;
    for (const detail::SimulatedPerson& person : persons) {
      if (person.covers(pixel) && (!owner || person.z < owner->z)) owner = &person;
    }
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
    if (owner) {
      ++on_people;
      z = owner->z;
      const Eigen::Vector3d limb(draws.normal(), draws.normal(), draws.normal());
      moved = seconds * (owner->velocity + simulation.limbs * limb);
    }
    const Eigen::Vector3d there =
        T_world_second.inverse() * (T_world_first * camera.back_project(pixel, z) + moved);
    const auto second_pixel = camera.project(there);
    if (!second_pixel || !camera.in_image(*second_pixel)) continue;
    const detail::MeasuredPoint first(pixel, z, camera, simulation.pixel, draws);
    const detail::MeasuredPoint second(*second_pixel, there.z(), camera, simulation.pixel, draws);
    made.features.push_back(
        {first.pixel,
         first.z,
         owner != nullptr,
         {first.position, second.position, first.covariance, second.covariance}});
  }
  if (simulation.features > 0) {
    made.covered = static_cast<double>(on_people) / static_cast<double>(simulation.features);
  }
  return made;
}

}  // namespace bench
