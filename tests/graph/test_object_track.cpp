// SPDX-License-Identifier: MIT
#include <limits>
#include <random>
#include <vector>

#include <Eigen/LU>

#include <topobag/graph/object_track.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

ObjectTrack<> track_of(const std::vector<SemanticNode<>>& nodes) {
  ObjectTrack<> track;
  for (const auto& node : nodes) track.sightings.push_back({track.sightings.size(), node});
  return track;
}

SemanticNode<> voting(int label, double confidence) {
  SemanticNode<> node = object_at(label, {0, 0, 3});
  node.confidence = confidence;
  return node;
}

}  // namespace

TEST_CASE("an object's class is the one with the most confidence behind it", "[graph]") {
  CHECK(track_of({voting(4, 0.5)}).label() == ClassId{4});
  CHECK(track_of({voting(1, 0.4), voting(2, 0.9), voting(1, 0.4)}).label() == ClassId{2});
  CHECK(track_of({voting(1, 0.5), voting(2, 0.9), voting(1, 0.5)}).label() == ClassId{1});
  CHECK(track_of({voting(7, 0.5), voting(3, 0.5)}).label() == ClassId{3});
}

TEST_CASE("one sighting is fused to itself", "[graph]") {
  const SemanticNode<> node = voting(4, 0.7);
  const SemanticNode<> fused = track_of({node}).fused(0.5);
  CHECK(fused.position->isApprox(*node.position));
  CHECK(fused.covariance.isApprox(node.covariance));
  CHECK(fused.size == node.size);
  CHECK(fused.confidence == 0.7);
}

TEST_CASE("positions are fused by their information", "[graph]") {
  std::mt19937 random(31);
  SemanticNode<> a = object_at(1, {0, 0, 3}), b = object_at(1, {0.3, 0, 3});
  a.covariance = 0.02 * Eigen::Matrix3d::Identity();
  b.covariance = 0.01 * Eigen::Matrix3d::Identity();
  CHECK(track_of({a, b}).fused(0.0).position->isApprox(Eigen::Vector3d(0.2, 0, 3)));

  a.covariance = random_covariance(random, 0.1);
  b.covariance = random_covariance(random, 0.1);
  // The reference: the Kalman update of a by b.
  const Eigen::Matrix3d gain = a.covariance * (a.covariance + b.covariance).inverse();
  const Eigen::Vector3d expected = *a.position + gain * (*b.position - *a.position);
  const SemanticNode<> fused = track_of({a, b}).fused(0.0);
  CHECK(fused.position->isApprox(expected, 1e-9));
  CHECK(fused.covariance.isApprox((Eigen::Matrix3d::Identity() - gain) * a.covariance, 1e-9));
}

TEST_CASE("common errors do not average out", "[graph]") {
  const std::vector<SemanticNode<>> same(4, object_at(1, {0, 0, 3}));
  const Eigen::Matrix3d one = same[0].covariance;
  CHECK(track_of(same).fused(0.0).covariance.isApprox(one / 4.0));
  CHECK(track_of(same).fused(1.0).covariance.isApprox(one));
  CHECK(track_of(same).fused(0.5).covariance.isApprox(one * 2.5 / 4.0));
}

TEST_CASE("one bad box does not change the size", "[graph]") {
  std::vector<SemanticNode<>> nodes(3, object_at(1, {0, 0, 3}));
  nodes[1].size = {3.0, 0.01};
  nodes[2].confidence = 0.4;
  const SemanticNode<> fused = track_of(nodes).fused(0.5);
  CHECK(fused.size == Eigen::Vector2d(0.2, 0.2));
  CHECK(fused.confidence == 1.0);
}

TEST_CASE("of two sizes the larger counts: a box may have been cut", "[graph]") {
  std::vector<SemanticNode<>> nodes(2, object_at(1, {0, 0, 3}));
  nodes[1].size = {0.3, 0.1};
  CHECK(track_of(nodes).fused(0.5).size == Eigen::Vector2d(0.3, 0.2));
}

TEST_CASE("nodes are apart by the noise along the line between them", "[graph]") {
  SemanticNode<> a = object_at(1, {0, 0, 3}), b = object_at(1, {0.3, 0, 3});
  a.covariance = Eigen::Vector3d(0.006, 1, 1).asDiagonal();
  b.covariance = Eigen::Vector3d(0.004, 1, 1).asDiagonal();
  CHECK(deviations_apart(a, b) == Approx(3.0));
  CHECK(deviations_apart(b, a) == Approx(3.0));
  CHECK(deviations_apart(a, a) == 0.0);
  a.covariance.setZero();
  b.covariance.setZero();
  CHECK(deviations_apart(a, b) == std::numeric_limits<double>::infinity());
}

TEST_CASE("an object looks like the mean of its sightings that say so", "[graph][appearance]") {
  const AppearanceKind kind("plane", 2);
  std::vector<SemanticNode<>> nodes(3, object_at(1, {0, 0, 3}));
  CHECK_FALSE(track_of(nodes).fused(0.5).appearance.known());
  nodes[1].appearance = Appearance(kind, Appearance::Bytes{127, 0});
  CHECK(track_of(nodes).fused(0.5).appearance == nodes[1].appearance);
  nodes[2].appearance = Appearance(kind, Appearance::Bytes{0, 40});
  CHECK(track_of(nodes).fused(0.5).appearance == Appearance(kind, Appearance::Bytes{127, 127}));
}

TEST_CASE("an object may be what its sightings say together", "[graph]") {
  std::vector<SemanticNode<>> nodes{voting(1, 0.5), voting(1, 0.5), voting(2, 1.0)};
  CHECK(track_of(nodes).fused(0.5).label_weights.empty());
  nodes[0].label_weights = LabelWeights({{ClassId{1}, 0.6}, {ClassId{2}, 0.4}});
  const SemanticNode<> fused = track_of(nodes).fused(0.5);
  CHECK(fused.label == ClassId{2});  // 0.2 + 1.0 against 0.3 + 0.5
  REQUIRE(fused.label_weights.size() == 2);
  CHECK(fused.label_weights.label(0) == ClassId{2});
  CHECK(fused.label_weights.byte(1) == Approx(255.0 * 0.8 / 1.2).margin(1.0));
}
