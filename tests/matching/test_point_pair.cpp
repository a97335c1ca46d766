// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <topobag/matching/point_pair.hpp>
#include <topobag/matching/refine_pose.hpp>
#include <topobag/sensing/pinhole_camera.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

/// Two nodes of one object 2 m before each camera, 0.2 m × 0.2 m.
PointPair object_ahead() {
  return point_pair(object_at(1, {0, 0, 2}, 0.03), object_at(1, {0, 0, 2}, 0.03));
}

/// Turned about the y axis through the object.
Eigen::Isometry3d seen_from_aside(double angle) {
  return Eigen::Translation3d(0, 0, 2) * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()) *
         Eigen::Translation3d(0, 0, -2);
}

/// A cuboid, upright in the frame of the first camera.
struct Box {
  Eigen::Vector3d center, sides;  ///< m
  double depth_share = 0.0;  ///< of the way from its nearest face to its centre, that is ranged
};

/// What a camera and a detector make of a box: the middle of its outline, at the depth ranged.
SemanticNode<> sighted(std::mt19937& random, const Box& box,
                       const Eigen::Isometry3d& T_camera_room) {
  std::normal_distribution<double> normal;
  const PinholeCamera<> camera{525.0, 525.0, 319.5, 239.5, 0, 0};
  Eigen::Array2d least = Eigen::Array2d::Constant(1e9), most = -least;
  double front = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5,
                               corner & 4 ? 0.5 : -0.5);
    const Eigen::Vector3d point =
        T_camera_room * Eigen::Vector3d(box.center + sign.cwiseProduct(box.sides));
    const Eigen::Array2d pixel = camera.project(point)->array();
    least = least.min(pixel);
    most = most.max(pixel);
    front = std::min(front, point.z());
  }
  const Eigen::Array2d extent = most - least;
  SemanticNode<> node;
  const double center = (T_camera_room * box.center).z();
  node.z = (front + box.depth_share * (center - front)) * (1.0 + 0.015 * normal(random));
  const double u = normal(random), v = normal(random);
  const Eigen::Array2d jitter = Eigen::Array2d(u, v) * (0.04 * extent + 1.0);
  node.position = camera.back_project(Eigen::Vector2d(0.5 * (least + most) + jitter), node.z);
  node.size = extent.matrix() * node.z / 525.0;
  node.covariance = NodeNoise{}.covariance(*node.position, node.size, false);
  return node;
}

/// Mean NEES of poses over boxes about 3 m away, which another camera sees from `angle` aside.
double mean_nees(std::size_t boxes, double angle, bool alike = false) {
  std::mt19937 random(55);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Eigen::Isometry3d T = Eigen::Translation3d(0, 0, 3) *
                              Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()) *
                              Eigen::Translation3d(0, 0, -3);
  const int matches = 1000;
  double sum = 0.0;
  for (int match = 0; match < matches; ++match) {
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < boxes; ++i) {
      const double x = unit(random), y = unit(random), z = unit(random);
      const double a = unit(random), b = unit(random), c = unit(random);
      const Box box{{2.4 * x - 1.2, 1.2 * y - 0.6, 2.4 * z + 1.8},
                    {0.1 + 0.6 * a, 0.1 + 0.6 * b, 0.1 + 0.6 * c},
                    unit(random)};
      const SemanticNode<> there = sighted(random, box, Eigen::Isometry3d::Identity());
      pairs.push_back(point_pair(there, sighted(random, box, T.inverse())));
      if (alike) pairs.back() = pairs.back().seen_alike();
    }
    const RefinedPose pose = refine_pose(T, pairs);
    const Eigen::Isometry3d error = T * pose.T_target_source.inverse();
    const Eigen::AngleAxisd turn(error.linear());
    Eigen::Matrix<double, 6, 1> xi;
    xi << error.translation(), turn.angle() * turn.axis();
    sum += xi.dot(pose.covariance.ldlt().solve(xi));
  }
  return sum / matches;
}

}  // namespace

TEST_CASE("a pair's deviation is its residual in standard deviations", "[matching]") {
  Eigen::Matrix3d target = Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal();
  const PointPair pair{{0.1, 0.4, 0.9}, {0, 0, 0}, target, Eigen::Matrix3d::Zero()};
  const Eigen::Isometry3d identity = Eigen::Isometry3d::Identity();
  CHECK(pair.squared_deviation(identity) == Approx(1.0 + 4.0 + 9.0));
  // A quarter turn about z carries the source's x deviation to y.
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ()));
  const PointPair turned{{0, 0, 0}, {0, 0, 0}, Eigen::Matrix3d::Zero(), target};
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.04, 0.01, 0.09).asDiagonal();
  CHECK(turned.covariance(turn).isApprox(expected));
}

TEST_CASE("a pair of nodes has their positions and the noise model's covariances", "[matching]") {
  std::mt19937 random(1);
  const auto graph = random_graph(random, 2);
  const SemanticNode<>&there = graph.nodes()[0], &here = graph.nodes()[1];
  const PointPair pair = point_pair(there, here);
  CHECK(pair.target == *there.position);
  CHECK(pair.source == *here.position);
  CHECK(pair.target_covariance == position_covariance(there));
  CHECK(pair.source_covariance == position_covariance(here));
}

TEST_CASE("a pair seen from one side has the measurements' covariance alone", "[matching]") {
  std::mt19937 random(2);
  const PointPair pair = object_ahead();
  const Eigen::Matrix3d sum = pair.target_covariance + pair.source_covariance;
  CHECK(pair.covariance(Eigen::Isometry3d::Identity()).isApprox(sum));
  for (int round = 0; round < 100; ++round) {
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    CHECK(pair.seen_alike().covariance(T).isApprox(sum));
    CHECK(pair.seen_alike().residual(T) == pair.residual(T));
    // A point without a size has no other side.
    auto node = object_at(1, {0.3, 0.2, 2}, 0.03);
    node.size.setZero();
    CHECK(point_pair(node, node).covariance(T).isApprox(sum));
  }
}

TEST_CASE("a pair's covariance grows with the turn of the view, up to a bound", "[matching]") {
  const PointPair pair = object_ahead();
  double last = 0.0;
  for (double angle = 0.0; angle <= M_PI; angle += 0.1) {
    const double trace = pair.covariance(seen_from_aside(angle)).trace();
    CHECK(trace > last);
    last = trace;
  }
  const double chord = 2.0 * 0.2;  // of opposite views
  const double front = PointPair::front_share * chord, outline = PointPair::outline_share * chord;
  const Eigen::Matrix3d opposite = pair.covariance(seen_from_aside(M_PI));
  CHECK(opposite(2, 2) == Approx(2 * 0.03 * 0.03 + front * front + outline * outline));
  CHECK(opposite(0, 0) == Approx(2 * 0.03 * 0.03 + outline * outline));
  // The chord between two rays that are a quarter turn apart, in the target's frame.
  const Eigen::Matrix3d quarter =
      pair.covariance(seen_from_aside(M_PI / 2)) - 2 * 0.03 * 0.03 * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d along = Eigen::Vector3d(-1, 0, 1).normalized();
  CHECK(along.dot(quarter * along) == Approx(0.5 * (front * front + outline * outline)));
  CHECK(quarter(1, 1) == Approx(0.5 * outline * outline));
}

TEST_CASE("a pair's covariance is positive definite, and bounded by the object's size",
          "[matching]") {
  std::mt19937 random(3);
  for (int round = 0; round < 500; ++round) {
    const auto graph = noisy_graph(random, 2, 2);
    const auto &there = graph.nodes()[0], &here = graph.nodes()[1];
    const PointPair pair = point_pair(there, here);
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    const Eigen::Matrix3d covariance = pair.covariance(T);
    CHECK(covariance.isApprox(covariance.transpose()));
    const Eigen::Matrix3d added = covariance - pair.seen_alike().covariance(T);
    const Eigen::Vector3d least =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues();
    CHECK(least.minCoeff() > 0.0);
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(added).eigenvalues().minCoeff() > -1e-12);
    const double size2 = std::sqrt(there.size.prod() * here.size.prod());
    const auto square = [](double x) { return x * x; };
    CHECK(added.trace() <=
          4.0 * size2 * (square(PointPair::front_share) + 3.0 * square(PointPair::outline_share)) +
              1e-12);
  }
}

TEST_CASE("no pose gives a pair's residual more variance than the pair says", "[matching]") {
  std::mt19937 random(23);
  double closest = 0.0;
  for (int round = 0; round < 300; ++round) {
    const TopologyGraph<> target = noisy_graph(random, 1, 1), source = noisy_graph(random, 1, 1);
    const PointPair pair = point_pair(target.nodes().front(), source.nodes().front());
    const Eigen::Matrix3d covariance = pair.covariance(random_motion(random, 1.0));
    const double greatest =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues()(2);
    CHECK(greatest <= pair.max_variance());
    closest = std::max(closest, greatest / pair.max_variance());
  }
  CHECK(closest > 0.3);
}

TEST_CASE("a pair looked at from the other graph is the same pair", "[matching]") {
  std::mt19937 random(4);
  for (int round = 0; round < 100; ++round) {
    const auto graph = noisy_graph(random, 2, 2);
    const PointPair pair = point_pair(graph.nodes()[0], graph.nodes()[1]);
    const PointPair swapped = point_pair(graph.nodes()[1], graph.nodes()[0]);
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    const Eigen::Matrix3d R = T.linear();
    CHECK(pair.covariance(T).isApprox(R * swapped.covariance(T.inverse()) * R.transpose()));
    CHECK(pair.squared_deviation(T) == Approx(swapped.squared_deviation(T.inverse())));
  }
}

TEST_CASE("a pose over boxes seen from aside knows its doubt", "[matching]") {
  // The mean of the normalised estimation error squared is 6 where covariances are right. From one
  // side both cameras share the front's error, and the noise model is on the safe side.
  for (const std::size_t boxes : {4U, 8U}) {
    for (const double degrees : {0.0, 30.0, 60.0, 90.0}) {
      const double angle = degrees * M_PI / 180.0;
      CAPTURE(boxes, degrees);
      const double nees = mean_nees(boxes, angle);
      CHECK(nees > 3.0);
      CHECK(nees < 12.0);
    }
    // As if all were seen from one side, the pose would be much too sure.
    CHECK(mean_nees(boxes, M_PI / 3.0, true) > 12.0);
  }
}
