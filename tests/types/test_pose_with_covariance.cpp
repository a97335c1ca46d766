// SPDX-License-Identifier: MIT
#include <topobag/types/pose_with_covariance.hpp>

#include <random>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "catch.hpp"

using namespace topobag;

namespace {

using Error = Eigen::Matrix<double, 6, 1>;
using ErrorCovariance = Eigen::Matrix<double, 6, 6>;
using LeftPose = PoseWithCovariance<>;
using LeftTurnFirst = PoseWithCovariance<ErrorSide::left, ErrorOrder::rotation_translation>;

Error normal_error(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Error::NullaryExpr([&] { return normal(random); });
}

Eigen::Isometry3d motion_of(const Eigen::Vector3d& translation, const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  return Eigen::Translation3d(translation) *
         Eigen::AngleAxisd(angle,
                           angle > 0.0 ? Eigen::Vector3d(turn / angle) : Eigen::Vector3d::UnitX());
}

Eigen::Isometry3d somewhere(std::mt19937& random) {
  const Error e = normal_error(random);
  return motion_of(3.0 * e.head<3>(), e.tail<3>());
}

/// Millimetres and hundredths of a degree, correlated: so small that the first order tells all.
ErrorCovariance small_covariance(std::mt19937& random) {
  ErrorCovariance root;
  for (Eigen::Index i = 0; i < 6; ++i) root.col(i) = 0.0004 * normal_error(random);
  return root * root.transpose() + 1e-8 * ErrorCovariance::Identity();
}

// What the names of sides and orders mean, written down once more by hand.
Eigen::Isometry3d moved_left(const Eigen::Isometry3d& T, const Error& xi) {
  return motion_of(xi.head<3>(), xi.tail<3>()) * T;
}
Error left_error(const Eigen::Isometry3d& T, const Eigen::Isometry3d& T_true) {
  const Eigen::Isometry3d between = T_true * T.inverse();
  const Eigen::AngleAxisd turn(between.linear());
  Error xi;
  xi << between.translation(), turn.angle() * turn.axis();
  return xi;
}
Error gtsam_error(const Eigen::Isometry3d& T, const Eigen::Isometry3d& T_true) {
  const Eigen::Isometry3d between = T.inverse() * T_true;
  const Eigen::AngleAxisd turn(between.linear());
  Error xi;
  xi << turn.angle() * turn.axis(), between.translation();
  return xi;
}

/// By how much the covariance of the errors differs from what is stated, in its own deviations.
template <typename Draw>
double misfit(const ErrorCovariance& stated, const Draw& draw) {
  const int draws = 8000;
  ErrorCovariance measured = ErrorCovariance::Zero();
  for (int i = 0; i < draws; ++i) {
    const Error xi = draw();
    measured += xi * xi.transpose() / draws;
  }
  const ErrorCovariance root = stated.llt().matrixL();
  const ErrorCovariance inverse = root.inverse();
  return (inverse * measured * inverse.transpose() - ErrorCovariance::Identity())
      .cwiseAbs()
      .maxCoeff();
}

}  // namespace

TEST_CASE("the covariance of another reading is that of errors read so", "[types]") {
  std::mt19937 random(1);
  for (int round = 0; round < 3; ++round) {
    const LeftPose pose{somewhere(random), small_covariance(random)};
    const ErrorCovariance root = pose.covariance.llt().matrixL();
    const auto gtsam = pose.as<GtsamPose>();
    CHECK(gtsam.T.matrix() == pose.T.matrix());
    CHECK(misfit(gtsam.covariance, [&] {
            return gtsam_error(pose.T, moved_left(pose.T, root * normal_error(random)));
          }) < 0.1);
    const auto back = gtsam.as<LeftPose>();
    CHECK(back.covariance.isApprox(pose.covariance, 1e-9));
    const auto g2o = gtsam.as<G2oPose>();
    CHECK(g2o.covariance.topLeftCorner<3, 3>().isApprox(gtsam.covariance.bottomRightCorner<3, 3>(),
                                                        1e-9));
    CHECK(g2o.covariance.topRightCorner<3, 3>().isApprox(gtsam.covariance.bottomLeftCorner<3, 3>(),
                                                         1e-9));
    const auto turn_first = pose.as<LeftTurnFirst>();
    CHECK(turn_first.covariance.topLeftCorner<3, 3>() == pose.covariance.bottomRightCorner<3, 3>());
  }
}

TEST_CASE("the covariance of an inverse and of a product is that of drawn poses", "[types]") {
  std::mt19937 random(2);
  for (int round = 0; round < 3; ++round) {
    const LeftPose first{somewhere(random), small_covariance(random)};
    const LeftPose second{somewhere(random), small_covariance(random)};
    const ErrorCovariance of_first = first.covariance.llt().matrixL();
    const ErrorCovariance of_second = second.covariance.llt().matrixL();
    const auto draw_first = [&] { return moved_left(first.T, of_first * normal_error(random)); };
    const auto draw_second = [&] { return moved_left(second.T, of_second * normal_error(random)); };
    const LeftPose inverse = first.inverse(), product = first * second;
    CHECK(inverse.T.isApprox(first.T.inverse(), 1e-12));
    CHECK(product.T.isApprox(first.T * second.T, 1e-12));
    CHECK(misfit(inverse.covariance,
                 [&] { return left_error(inverse.T, draw_first().inverse()); }) < 0.1);
    CHECK(misfit(product.covariance,
                 [&] { return left_error(product.T, draw_first() * draw_second()); }) < 0.1);
    // The same in whatever reading it is worked out.
    const auto elsewhere = first.as<GtsamPose>() * second.as<GtsamPose>();
    CHECK(elsewhere.as<LeftPose>().covariance.isApprox(product.covariance, 1e-9));
    const auto inverse_elsewhere = first.as<GtsamPose>().inverse();
    CHECK(inverse_elsewhere.as<LeftPose>().covariance.isApprox(inverse.covariance, 1e-9));
  }
}

TEST_CASE("an exact pose adds nothing, and a pose is asked for by itself", "[types]") {
  std::mt19937 random(3);
  const LeftPose exact{somewhere(random), ErrorCovariance::Zero()};
  const LeftPose pose{somewhere(random), small_covariance(random)};
  CHECK((pose * exact).covariance.isApprox(pose.covariance, 1e-12));
  CHECK((exact * exact).covariance.isZero());
  const Eigen::Isometry3d T = pose;
  CHECK(T.matrix() == pose.T.matrix());
}
