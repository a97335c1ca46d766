// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/recognition/verify_candidates.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// The best poses of a graph matched with itself, and what is decided.
void check_two_fold(const TopologyGraph<>& room, const Eigen::Isometry3d& T_symmetry) {
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{0}, room);
  const Recognition recognition = verify_candidates(bag, room, {{KeyframeId{0}, 1.0}});
  CHECK_FALSE(recognition);
  REQUIRE(recognition.candidates.size() == 1);
  const CandidateReport& report = recognition.candidates[0];
  CHECK(report.verdict == Verdict::ambiguous);
  CHECK(report.margin() > 0.0);  // it is the symmetry that keeps it from being accepted
  REQUIRE_FALSE(report.other_poses.empty());
  const RelativePose &one = *report.pose, &other = report.other_poses.front();
  CHECK(one.inliers.size() == room.size());
  CHECK(other.inliers.size() == room.size());
  CHECK(other.support() == Approx(one.support()).margin(1e-6));
  for (const Eigen::Isometry3d& expected : {Eigen::Isometry3d::Identity(), T_symmetry}) {
    const auto is_it = [&](const RelativePose& pose) {
      return pose.T_candidate_query.isApprox(expected, 1e-6);
    };
    CHECK((is_it(one) || is_it(other)));
  }
}

SemanticNode<> object(int label, const Eigen::Vector3d& position) {
  SemanticNode<> node;
  node.label = ClassId{label};
  node.position = position;
  node.size = {0.2, 0.2};
  node.covariance = 4e-4 * Eigen::Matrix3d::Identity();
  return node;
}

}  // namespace

TEST_CASE("a square of equal objects fits four ways and is ambiguous", "[recognition]") {
  std::vector<SemanticNode<>> nodes;
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, -1),
                                        Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1)}) {
    SemanticNode<> node;
    node.label = ClassId{5};
    node.position = Eigen::Vector3d(corner.x(), corner.y(), 3.0);
    node.size = {0.2, 0.2};
    node.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    nodes.push_back(node);
  }
  const TopologyGraph<> square(std::move(nodes));
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{0}, square);
  RecognitionOptions options;
  options.decision.min_score = -100.0;  // the symmetry alone decides
  const Recognition recognition = verify_candidates(bag, square, {{KeyframeId{0}, 1.0}}, options);
  REQUIRE(recognition.candidates.size() == 1);
  CHECK(recognition.candidates[0].other_poses.size() >= 3);
  CHECK(recognition.candidates[0].verdict == Verdict::ambiguous);
  CHECK_FALSE(recognition);
}

TEST_CASE("a room turned on itself gives both poses, equally good, and is not accepted",
          "[recognition]") {
  // Every object has a twin, half a turn about the vertical through (0, ·, 4) away.
  const Eigen::Isometry3d T_symmetry = Eigen::Translation3d(0, 0, 4) *
                                       Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()) *
                                       Eigen::Translation3d(0, 0, -4);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> metres(-1.5, 1.5);
  for (int round = 0; round < 20; ++round) {
    std::vector<SemanticNode<>> nodes;
    for (int i = 0; i < 5; ++i) {
      const double x = metres(random), y = metres(random), z = metres(random);
      nodes.push_back(object(i, {x, y, 4.0 + z}));
      nodes.push_back(object(i, T_symmetry * *nodes.back().position));
    }
    check_two_fold(TopologyGraph<>(std::move(nodes)), T_symmetry);
  }
}

TEST_CASE("a table mirrored on itself gives both poses, equally good, and is not accepted",
          "[recognition]") {
  // In the plane y = 1 the mirror x → −x is half a turn about the z axis through it.
  const Eigen::Isometry3d T_symmetry = Eigen::Translation3d(0, 1, 0) *
                                       Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()) *
                                       Eigen::Translation3d(0, -1, 0);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> metres(0.3, 1.5);
  for (int round = 0; round < 20; ++round) {
    std::vector<SemanticNode<>> nodes;
    for (int i = 0; i < 5; ++i) {
      const double x = metres(random), z = metres(random);
      nodes.push_back(object(i, {x, 1.0, 2.0 + z}));
      nodes.push_back(object(i, {-x, 1.0, 2.0 + z}));
    }
    check_two_fold(TopologyGraph<>(std::move(nodes)), T_symmetry);
  }
}
