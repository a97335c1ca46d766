// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>

/// Objects strewn over a table of 3 × 2 m, up to 0.4 m high.
inline std::vector<Eigen::Vector3d> strewn_objects(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(0.0, 3.0), y(0.0, 2.0), z(0.0, 0.4);
  std::vector<Eigen::Vector3d> objects;
  for (std::size_t i = 0; i < count; ++i) objects.push_back({x(random), y(random), z(random)});
  return objects;
}

/// Where another system has them: moved, turned and scaled, each off by `deviation` along each
/// axis.
inline std::vector<Eigen::Vector3d> mapped_elsewhere(const std::vector<Eigen::Vector3d>& objects,
                                                     const Eigen::Isometry3d& T_map, double scale,
                                                     double deviation, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, deviation);
  std::vector<Eigen::Vector3d> mapped;
  for (const Eigen::Vector3d& object : objects) {
    const Eigen::Vector3d off(noise(random), noise(random), noise(random));
    mapped.push_back(scale * (T_map * object) + off);
  }
  return mapped;
}

/// A motion of another world.
inline Eigen::Isometry3d some_motion() {
  return Eigen::Translation3d(1.0, -2.0, 0.5) *
         Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.2, 0.5, -0.8).normalized());
}

/// The text of a map of objects; the object i has class `labels[i]`.
inline std::string object_map_text(const std::vector<Eigen::Vector3d>& positions,
                                   const std::vector<int>& labels) {
  std::ostringstream text;
  text.precision(12);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Eigen::Vector3d& p = positions[i];
    text << (i == 0 ? "{\"nodes\": [" : ", ") << "{\"translation\": [" << p.x() << ", " << p.y()
         << ", " << p.z() << "], \"baseline_label\": {\"" << labels[i] << ".0\": [1.0]}}";
  }
  text << "]}";
  return text.str();
}
