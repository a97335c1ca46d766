// SPDX-License-Identifier: MIT
#include <topobag/evaluation/g2o_text.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>

#include "catch.hpp"
#include "error_text.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;

namespace {

using EdgeMatrix = Eigen::Matrix<double, 6, 6>;
using EdgeVector = Eigen::Matrix<double, 6, 1>;

/// A line of the file as its readers take it.
struct EdgeLine {
  std::string tag;
  std::uint64_t from = 0, to = 0;
  Eigen::Isometry3d T_from_to;
  EdgeMatrix information;
};

Eigen::Isometry3d pose_in(std::istream& stream) {
  Eigen::Vector3d t;
  Eigen::Quaterniond q;
  stream >> t.x() >> t.y() >> t.z() >> q.x() >> q.y() >> q.z() >> q.w();
  return Eigen::Translation3d(t) * q;
}

EdgeLine edge_in(const std::string& text) {
  std::istringstream stream(text);
  EdgeLine edge;
  stream >> edge.tag >> edge.from >> edge.to;
  edge.T_from_to = pose_in(stream);
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = row; column < 6; ++column) {
      stream >> edge.information(row, column);
      edge.information(column, row) = edge.information(row, column);
    }
  }
  REQUIRE(stream);
  CHECK(stream.get() == '\n');
  CHECK(stream.get() == EOF);
  return edge;
}

/// The error of g2o's EdgeSE3: translation and the quaternion's x, y, z of Z⁻¹ · X_from⁻¹ · X_to.
EdgeVector g2o_error(const Eigen::Isometry3d& Z, const Eigen::Isometry3d& T_from_to) {
  const Eigen::Isometry3d delta = Z.inverse() * T_from_to;
  Eigen::Quaterniond q(delta.linear());
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  EdgeVector error;
  error << delta.translation(), q.vec();
  return error;
}

/// A pose whose covariance, left and translation first, is that of `drawn` poses.
PoseWithCovariance<> some_pose(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const EdgeMatrix root = EdgeMatrix::NullaryExpr([&] { return 0.0004 * normal(random); });
  return {topobag_tests::random_pose(random),
          root * root.transpose() + 1e-8 * EdgeMatrix::Identity()};
}

Eigen::Isometry3d drawn(const PoseWithCovariance<>& pose, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const EdgeMatrix root = pose.covariance.llt().matrixL();
  const EdgeVector xi = root * EdgeVector::NullaryExpr([&] { return normal(random); });
  const Eigen::Vector3d turn = xi.tail<3>();
  return Eigen::Translation3d(xi.head<3>()) * Eigen::AngleAxisd(turn.norm(), turn.normalized()) *
         pose.T;
}

}  // namespace

TEST_CASE("a vertex is read back as it was", "[evaluation]") {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    const Eigen::Isometry3d T = topobag_tests::random_pose(random);
    std::ostringstream text;
    write_g2o_vertex(text, KeyframeId{18446744073709551615U}, T);
    std::istringstream stream(text.str());
    std::string tag;
    std::uint64_t id = 0;
    stream >> tag >> id;
    CHECK(tag == "VERTEX_SE3:QUAT");
    CHECK(id == 18446744073709551615U);
    CHECK(pose_in(stream).isApprox(T, 1e-14));
    CHECK(stream.get() == '\n');
  }
}

TEST_CASE("an edge's information is that of g2o's error of drawn poses", "[evaluation]") {
  std::mt19937 random(2);
  const PoseWithCovariance<> pose = some_pose(random);
  std::ostringstream text;
  write_g2o_edge(text, KeyframeId{3}, KeyframeId{14}, pose);
  const EdgeLine edge = edge_in(text.str());
  CHECK(edge.tag == "EDGE_SE3:QUAT");
  CHECK(edge.from == 3);
  CHECK(edge.to == 14);
  CHECK(edge.T_from_to.isApprox(pose.T, 1e-14));
  const int draws = 8000;
  EdgeMatrix measured = EdgeMatrix::Zero();
  for (int i = 0; i < draws; ++i) {
    const EdgeVector error = g2o_error(edge.T_from_to, drawn(pose, random));
    measured += error * error.transpose() / draws;
  }
  const EdgeMatrix root = edge.information.llt().matrixU();
  const EdgeMatrix whitened = root * measured * root.transpose() - EdgeMatrix::Identity();
  CHECK(whitened.cwiseAbs().maxCoeff() < 0.1);
}

TEST_CASE("for a reader that takes rotations in rad, the information is that of GTSAM's noise",
          "[evaluation]") {
  std::mt19937 random(3);
  const auto pose = some_pose(random);
  std::ostringstream text;
  write_g2o_edge(text, KeyframeId{1}, KeyframeId{2}, pose.as<GtsamPose>(),
                 G2oRotation::rotation_vector);
  const EdgeMatrix information = edge_in(text.str()).information;
  // As GTSAM's reader puts the rotation first.
  EdgeMatrix gtsam;
  gtsam << information.bottomRightCorner<3, 3>(), information.bottomLeftCorner<3, 3>(),
      information.topRightCorner<3, 3>(), information.topLeftCorner<3, 3>();
  CHECK((gtsam * pose.as<GtsamPose>().covariance).isIdentity(1e-6));
}

TEST_CASE("a pose that is no rigid motion is neither vertex nor edge", "[evaluation]") {
  std::mt19937 random(4);
  PoseWithCovariance<> pose = some_pose(random);
  pose.T.linear() *= 3.0;
  std::ostringstream text;
  CHECK(error_text([&] { write_g2o_vertex(text, KeyframeId{1}, pose.T); }) ==
        "the vertex's pose is no rigid motion: it scales by 3.000000; divide the rotation by that");
  CHECK(error_text([&] { write_g2o_edge(text, KeyframeId{1}, KeyframeId{2}, pose); }) ==
        "the edge's pose is no rigid motion: it scales by 3.000000; divide the rotation by that");
  CHECK(text.str().empty());
}

TEST_CASE("an exact pose is no factor", "[evaluation]") {
  std::ostringstream text;
  const PoseWithCovariance<> exact;
  CHECK(error_text([&] { write_g2o_edge(text, KeyframeId{1}, KeyframeId{2}, exact); }) ==
        "the covariance of an edge's pose has no inverse: a factor is uncertain in all six "
        "directions");
  CHECK(text.str().empty());
}
