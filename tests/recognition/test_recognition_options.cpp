// SPDX-License-Identifier: MIT
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include <topobag/evaluation/pose_error.hpp>
#include <topobag/recognition/recognition_options.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/sensing/sensor_profile.hpp>
#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the options for a catalog join what detectors mix up", "[recognition]") {
  const ClassCatalog catalog = ClassCatalog::coco80();
  const RecognitionOptions options = recognition_options(catalog);
  CHECK(options.matching.consistency.classes.compatible(*catalog.find("tv"),
                                                        *catalog.find("laptop")));
  CHECK_FALSE(RecognitionOptions{}.matching.consistency.classes.compatible(
      *catalog.find("tv"), *catalog.find("laptop")));
}

namespace {

/// Cars, trees and posts about a LiDAR, each cluster's centroid as the profile says.
class Yard {
 public:
  explicit Yard(unsigned seed) : random_(seed) {
    std::uniform_real_distribution<double> metres(-40.0, 40.0), size(0.5, 4.0);
    std::uniform_int_distribution<int> label(0, 3);
    for (int i = 0; i < 14; ++i) {
      SemanticNode<> node;
      node.label = ClassId{label(random_)};
      const double x = metres(random_), z = metres(random_);
      node.position = Eigen::Vector3d(x, 0.0, z);
      const double width = size(random_), height = size(random_);
      node.size = {width, height};
      objects_.push_back(node);
    }
  }

  TopologyGraph<> seen_from(const Eigen::Isometry3d& T_yard_sensor, const NodeNoise& noise) {
    std::normal_distribution<double> normal;
    std::vector<SemanticNode<>> nodes = objects_;
    for (SemanticNode<>& node : nodes) {
      const Eigen::Vector3d exact = T_yard_sensor.inverse() * *node.position;
      node.covariance = noise.covariance(exact, node.size, false);
      const Eigen::Vector3d drawn(normal(random_), normal(random_), normal(random_));
      node.position = exact + node.covariance.llt().matrixL() * drawn;
      node.z = node.position->z();
    }
    return TopologyGraph<>(std::move(nodes));
  }

 private:
  std::mt19937 random_;
  std::vector<SemanticNode<>> objects_;
};

}  // namespace

TEST_CASE("the default options are those of the default sensor", "[recognition]") {
  const RecognitionOptions usual, made = recognition_options(SensorProfile::hand_held_rgbd());
  CHECK(made.matching.consistency.min_tolerance == usual.matching.consistency.min_tolerance);
  CHECK(made.matching.consistency.max_tolerance == usual.matching.consistency.max_tolerance);
  CHECK(made.matching.inlier_deviations == usual.matching.inlier_deviations);
  CHECK(made.matching.max_residual == usual.matching.max_residual);
  CHECK(made.matching.min_spread == usual.matching.min_spread);
  CHECK(made.matching.distinct_translation == usual.matching.distinct_translation);
  CHECK(made.matching.missing.max_depth == usual.matching.missing.max_depth);
  CHECK(made.place.distinct_translation == usual.place.distinct_translation);
  CHECK(made.place.radius == usual.place.radius);
  CHECK(made.place.margin == usual.place.margin);
  CHECK(made.place.max_depth == usual.place.max_depth);
  CHECK(made.place.fusing.gate == usual.place.fusing.gate);
  CHECK(made.place.fusing.max_depth == usual.place.fusing.max_depth);
}

TEST_CASE("a yard 80 m wide is recognised with a LiDAR's options", "[recognition]") {
  const SensorProfile lidar = SensorProfile::lidar();
  int found = 0, found_as_hand_held = 0;
  const int yards = 30;
  for (unsigned seed = 0; seed < yards; ++seed) {
    Yard yard(seed);
    const Eigen::Isometry3d moved =
        Eigen::Translation3d(3.0, 0.0, 2.0) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY());
    const auto before = yard.seen_from(Eigen::Isometry3d::Identity(), lidar.noise);
    const auto now = yard.seen_from(moved, lidar.noise);
    for (const bool with_profile : {true, false}) {
      Relocalizer<> relocalizer(with_profile ? recognition_options(lidar) : RecognitionOptions{});
      relocalizer.map().add(KeyframeId{1}, before);
      const Recognition recognised = relocalizer.localize(now);
      if (!recognised) continue;
      const auto error = pose_error(moved, recognised.accepted->pose->T_candidate_query);
      CHECK(error.translation_m < 1.0);
      ++(with_profile ? found : found_as_hand_held);
    }
  }
  CAPTURE(found, found_as_hand_held);
  CHECK(found >= 27);
  CHECK(found_as_hand_held < found);
}
