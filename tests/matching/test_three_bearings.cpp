// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>

#include <topobag/matching/three_bearings.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// A camera before three points, and where it sees them.
struct ThreeSeen {
  ThreeVectors points{}, bearings{};
  Eigen::Isometry3d T_target_camera = Eigen::Isometry3d::Identity();
};

ThreeSeen three_seen(std::mt19937& random) {
  std::uniform_real_distribution<double> metres(-1.5, 1.5), any(-1.0, 1.0);
  const auto vector = [&](auto& from) {
    const double x = from(random), y = from(random), z = from(random);
    return Eigen::Vector3d(x, y, z);
  };
  ThreeSeen seen;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(3.0 * any(random), vector(any).normalized()));
  seen.T_target_camera = Eigen::Translation3d(vector(metres)) * turn;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d at = vector(metres) + Eigen::Vector3d(0.0, 0.0, 2.5);
    seen.bearings[i] = at.normalized();
    seen.points[i] = seen.T_target_camera * at;
  }
  return seen;
}

/// Greatest angle between a bearing and where a pose puts its point, rad.
double worst_bearing(const ThreeSeen& seen, const Eigen::Isometry3d& T_target_camera) {
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d at = (T_target_camera.inverse() * seen.points[i]).normalized();
    worst = std::max(worst, (at - seen.bearings[i]).norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("three bearings give the true pose, and none that does not see them",
          "[three_bearings]") {
  std::mt19937 random(7);
  std::size_t found = 0, poses = 0;
  const std::size_t rounds = 20000;
  for (std::size_t round = 0; round < rounds; ++round) {
    const ThreeSeen seen = three_seen(random);
    double nearest = std::numeric_limits<double>::infinity();
    const auto all = poses_from_three_bearings(seen.points, seen.bearings);
    CHECK(all.size() <= 4);
    for (const Eigen::Isometry3d& pose : all) {
      CHECK(worst_bearing(seen, pose) < 1e-6);
      CHECK(std::abs(pose.linear().determinant() - 1.0) < 1e-9);
      nearest = std::min(nearest, (pose.matrix() - seen.T_target_camera.matrix()).norm());
    }
    poses += all.size();
    if (nearest < 1e-4) ++found;
  }
  CHECK(found + rounds / 1000 >= rounds);  // where two answers nearly meet, both are inexact
  CHECK(poses > rounds);                   // the problem has more than one answer now and then
}

TEST_CASE("every pose that sees three points so is told", "[three_bearings]") {
  // By brute force: the sign changes of one law of cosines along the curve of the other two.
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const ThreeSeen seen = three_seen(random);
    const auto cosine = [&](std::size_t i, std::size_t j) {
      return seen.bearings[i].dot(seen.bearings[j]);
    };
    const auto squared = [&](std::size_t i, std::size_t j) {
      return (seen.points[i] - seen.points[j]).squaredNorm();
    };
    std::size_t crossings = 0;
    for (const double sign1 : {-1.0, 1.0}) {
      for (const double sign2 : {-1.0, 1.0}) {
        double last = std::numeric_limits<double>::quiet_NaN();
        const double reach =
            std::min(std::sqrt(squared(0, 1) / (1.0 - cosine(0, 1) * cosine(0, 1))),
                     std::sqrt(squared(0, 2) / (1.0 - cosine(0, 2) * cosine(0, 2))));
        for (double s = 1e-4; s < reach; s += 1e-4 * reach) {
          const auto other = [&](std::size_t j, double sign) {
            const double c = cosine(0, j);
            return s * c + sign * std::sqrt(squared(0, j) - s * s * (1.0 - c * c));
          };
          const double s1 = other(1, sign1), s2 = other(2, sign2);
          const double error =
              s1 > 0.0 && s2 > 0.0
                  ? s1 * s1 + s2 * s2 - 2.0 * s1 * s2 * cosine(1, 2) - squared(1, 2)
                  : std::numeric_limits<double>::quiet_NaN();
          if (last * error < 0.0) ++crossings;
          last = error;
        }
      }
    }
    // The curve's own ends may hide a crossing within one step.
    CHECK(poses_from_three_bearings(seen.points, seen.bearings).size() >= crossings);
  }
}

TEST_CASE("three bearings that pin nothing down give no pose", "[three_bearings]") {
  std::mt19937 random(5);
  ThreeSeen seen = three_seen(random);
  seen.points[2] = 0.3 * seen.points[0] + 0.7 * seen.points[1];  // on a line
  CHECK(poses_from_three_bearings(seen.points, seen.bearings).empty());
  seen = three_seen(random);
  seen.bearings[1] = seen.bearings[0];
  CHECK(poses_from_three_bearings(seen.points, seen.bearings).empty());
  seen = three_seen(random);
  seen.points[0] = seen.points[1];
  CHECK(poses_from_three_bearings(seen.points, seen.bearings).empty());
  seen = three_seen(random);
  seen.points[1].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(poses_from_three_bearings(seen.points, seen.bearings).empty());
}
