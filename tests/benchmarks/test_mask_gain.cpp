// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/evaluation/pose_error.hpp>
#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"
#include "mask_gain.hpp"

namespace mask_gain_test {

using bench::KeptFeatures;

const topobag::ClassCatalog coco = topobag::ClassCatalog::coco80();
const topobag::PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, 640, 480};

/// Of a camera that stands still, where the people named walk.
bench::SimulatedFeatures made_with(const std::vector<topobag::RangedDetection>& people,
                                   const bench::FeatureSimulation& simulation = {}) {
  program::Draws draws({7});
  const Eigen::Isometry3d still = Eigen::Isometry3d::Identity();
  return bench::simulate_features(people, camera, still, still, 0.1, simulation, draws);
}

double millimetres_of(const bench::SimulatedFeatures& made, KeptFeatures kept) {
  bench::MotionErrors errors;
  errors.add(bench::kept_pairs(made, kept, coco), std::nullopt, Eigen::Isometry3d::Identity());
  REQUIRE(errors.millimetres.size() == 1);
  return errors.millimetres[0];
}

std::vector<topobag::RangedDetection> crowd() {
  return {{{0.0, 0.0, 639.0, 479.0}, coco.at("person"), 0.9, 0.0}};
}

}  // namespace mask_gain_test

TEST_CASE("where nobody is, the mask changes nothing", "[benchmarks]") {
  using namespace mask_gain_test;
  const auto made = made_with({});
  REQUIRE(made.covered == 0.0);
  const double all = millimetres_of(made, KeptFeatures::all);
  for (const KeptFeatures kept : bench::all_kept_features) {
    CHECK(bench::kept_pairs(made, kept, coco).size() == made.features.size());
    CHECK(millimetres_of(made, kept) == all);
  }
}

TEST_CASE("what is masked is what lies in the box, and with depth at the person's",
          "[benchmarks]") {
  using namespace mask_gain_test;
  const std::vector<topobag::RangedDetection> left{
      {{0.0, 0.0, 320.0, 479.0}, coco.at("person"), 0.9, 0.0}};
  const auto made = made_with(left);
  std::size_t outside = 0, elsewhere = 0, standing = 0;
  for (const bench::SimulatedFeature& feature : made.features) {
    const bool boxed = feature.pixel.x() <= 323.0 && feature.pixel.x() >= -3.0 &&
                       feature.pixel.y() >= -3.0 && feature.pixel.y() <= 482.0;
    outside += !boxed;
    elsewhere += !boxed || std::abs(feature.z - made.people[0].z) > 0.5;
    standing += !feature.on_person;
  }
  CHECK(bench::kept_pairs(made, KeptFeatures::all, coco).size() == made.features.size());
  CHECK(bench::kept_pairs(made, KeptFeatures::outside_boxes, coco).size() == outside);
  CHECK(bench::kept_pairs(made, KeptFeatures::not_at_their_depth, coco).size() == elsewhere);
  CHECK(bench::kept_pairs(made, KeptFeatures::on_background, coco).size() == standing);
  CHECK(outside < elsewhere);
}

TEST_CASE("a person who fills the image drags the camera along, but for the mask with depth",
          "[benchmarks]") {
  using namespace mask_gain_test;
  bench::FeatureSimulation simulation;
  simulation.limbs = 0.0;
  simulation.nearest_person = simulation.furthest_person = 1.5;
  const auto made = made_with(crowd(), simulation);
  REQUIRE(made.covered > 0.7);
  CHECK(millimetres_of(made, KeptFeatures::all) > 10.0);
  CHECK(millimetres_of(made, KeptFeatures::not_at_their_depth) < 5.0);
  bench::MotionErrors errors;
  errors.add(bench::kept_pairs(made, KeptFeatures::outside_boxes, coco), std::nullopt,
             Eigen::Isometry3d::Identity());
  CHECK(errors.none == 1);
  CHECK(errors.millimetres.empty());
}

TEST_CASE("an exact set of pairs gives its motion from either start", "[benchmarks]") {
  Eigen::Isometry3d T_first_second = Eigen::Isometry3d::Identity();
  T_first_second.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T_first_second.translation() << 0.2, 0.1, -0.3;
  const Eigen::Matrix3d covariance = 1e-4 * Eigen::Matrix3d::Identity();
  std::vector<topobag::PointPair> pairs;
  for (const Eigen::Vector3d& second :
       {Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(1, 0, 3), Eigen::Vector3d(0, 1, 2.5)}) {
    pairs.push_back({T_first_second * second, second, covariance, covariance});
  }
  for (const auto& start : {std::optional<Eigen::Isometry3d>(), std::optional(T_first_second)}) {
    const auto motion = bench::camera_motion(pairs, start);
    REQUIRE(motion);
    CHECK(topobag::pose_error(T_first_second, *motion).translation_m < 1e-9);
  }
  pairs.pop_back();
  CHECK_FALSE(bench::camera_motion(pairs));
}

TEST_CASE("bands of what people cover end where they say", "[benchmarks]") {
  CHECK(bench::covered_band(0.0) == 0);
  CHECK(bench::covered_band(1e-9) == 1);
  for (std::size_t band = 0; band < bench::covered_band_ends.size(); ++band) {
    CHECK(bench::covered_band(bench::covered_band_ends[band]) == band);
  }
}
