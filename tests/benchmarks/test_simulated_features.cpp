// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"
#include "simulated_features.hpp"

namespace simulated_features_test {

const topobag::PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, 640, 480};
const topobag::ClassId person = topobag::ClassCatalog::coco80().at("person");
const std::vector<topobag::RangedDetection> middle{{{160.0, 60.0, 480.0, 420.0}, person, 0.9, 0.0}};

Eigen::Isometry3d small_step() {
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  step.linear() = Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitY()).toRotationMatrix();
  step.translation() << 0.03, -0.01, 0.05;
  return step;
}

bench::SimulatedFeatures made_with(const std::vector<topobag::RangedDetection>& people,
                                   const bench::FeatureSimulation& simulation,
                                   std::uint32_t seed = 1) {
  program::Draws draws({seed});
  return bench::simulate_features(people, camera, Eigen::Isometry3d::Identity(), small_step(), 0.5,
                                  simulation, draws);
}

}  // namespace simulated_features_test

TEST_CASE("a person's features lie in the ellipse of the box and at one depth", "[benchmarks]") {
  using namespace simulated_features_test;
  bench::FeatureSimulation simulation;
  simulation.pixel = 0.0;
  const auto made = made_with(middle, simulation);
  REQUIRE(made.people.size() == 1);
  std::size_t on_person = 0;
  for (const bench::SimulatedFeature& feature : made.features) {
    const Eigen::Vector2d off = feature.pixel - Eigen::Vector2d(320.0, 240.0);
    CHECK(feature.on_person == (std::hypot(off.x() / 160.0, off.y() / 180.0) <= 1.0));
    if (!feature.on_person) continue;
    ++on_person;
    CHECK(std::abs(feature.z - made.people[0].z) < 6.0 * bench::detail::depth_noise(2.5) * 1.5);
  }
  CHECK(on_person > 100);
  // The ellipse is π/4 of the box: 0.29 of the image.
  CHECK(std::abs(made.covered - 0.295) < 0.06);
}

TEST_CASE("background fits the camera's motion as well as its noise says, people do not",
          "[benchmarks]") {
  using namespace simulated_features_test;
  double background = 0.0, people = 0.0;
  std::size_t still = 0, moving = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    for (const bench::SimulatedFeature& feature : made_with(middle, {}, seed).features) {
      const double deviation = feature.pair.squared_deviation(small_step());
      (feature.on_person ? people : background) += deviation;
      ++(feature.on_person ? moving : still);
    }
  }
  // χ² with three degrees of freedom has a mean of 3.
  CHECK(std::abs(background / static_cast<double>(still) - 3.0) < 0.2);
  CHECK(people / static_cast<double>(moving) > 10.0);
}

TEST_CASE("people who stand still fit the camera's motion too", "[benchmarks]") {
  using namespace simulated_features_test;
  bench::FeatureSimulation simulation;
  simulation.speed = simulation.limbs = 0.0;
  double people = 0.0;
  std::size_t standing = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    for (const bench::SimulatedFeature& feature : made_with(middle, simulation, seed).features) {
      if (!feature.on_person) continue;
      people += feature.pair.squared_deviation(small_step());
      ++standing;
    }
  }
  REQUIRE(standing > 1000);
  CHECK(std::abs(people / static_cast<double>(standing) - 3.0) < 0.3);
}

TEST_CASE("a detector that misses everybody tells of nobody, and they walk all the same",
          "[benchmarks]") {
  using namespace simulated_features_test;
  bench::FeatureSimulation simulation;
  simulation.missed = 1.0;
  const auto made = made_with(middle, simulation);
  CHECK(made.people.empty());
  CHECK(made.covered > 0.2);
  CHECK(made_with({}, simulation).covered == 0.0);
}
