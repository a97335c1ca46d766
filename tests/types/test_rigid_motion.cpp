// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <topobag/types/rigid_motion.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

/// What is said of a transformation.
std::string rigidity(const Eigen::Isometry3d& T) {
  return error_text([&] { require_rigid(T, "the pose"); });
}

Eigen::Isometry3d turned() {
  return Eigen::Translation3d(1, 2, 3) *
         Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized());
}

}  // namespace

TEST_CASE("what turns and moves is a rigid motion, in single precision too", "[types]") {
  CHECK(rigidity(turned()) == "nothing was thrown");
  CHECK_NOTHROW(require_rigid(Eigen::Isometry3f(turned().cast<float>()), "the pose"));
  Eigen::Isometry3f many = Eigen::Isometry3f::Identity();
  for (int i = 0; i < 1000; ++i) many = many * Eigen::AngleAxisf(0.01F, Eigen::Vector3f::UnitY());
  CHECK_NOTHROW(require_rigid(many, "the pose"));
}

TEST_CASE("what mirrors, scales, shears or is no matrix of a motion is told apart", "[types]") {
  Eigen::Isometry3d T = turned();
  T.linear().col(0) *= -1.0;
  CHECK(rigidity(T) ==
        "the pose is no rigid motion: it mirrors; one of the two frames is left-handed");
  T = turned();
  T.linear() *= 2.0;
  CHECK(rigidity(T) ==
        "the pose is no rigid motion: it scales by 2.000000; divide the rotation by that");
  T = turned();
  T.linear().setZero();
  CHECK(rigidity(T) ==
        "the pose is no rigid motion: the columns of its rotation are not at right angles and of "
        "length 1");
  T = turned();
  T.linear()(0, 1) += 0.1;
  CHECK(rigidity(T).find("right angles") != std::string::npos);
  T = turned();
  T.matrix().transposeInPlace();
  CHECK(rigidity(T) ==
        "the pose is no rigid motion: its last row is not 0 0 0 1; is it transposed?");
  T = turned();
  T.translation().y() = std::numeric_limits<double>::infinity();
  CHECK(rigidity(T) == "the pose is no rigid motion: a number of it is not finite");
}

TEST_CASE("what rounding left askew is put right, and no more than that", "[types]") {
  Eigen::Matrix4d rounded = turned().matrix();
  rounded = (rounded * 100.0).array().round() / 100.0;
  const Eigen::Isometry3d T = nearest_rigid(rounded, "the pose", written_rotation_tolerance * 2);
  CHECK((T.linear() * T.linear().transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-14));
  CHECK(T.isApprox(turned(), 0.01));
  CHECK_THROWS_AS(nearest_rigid(rounded * 1.1, "the pose", written_rotation_tolerance),
                  InvalidValue);
}

TEST_CASE("seven numbers are a pose", "[types]") {
  const double half = std::sqrt(0.5);
  const std::array<double, 7> quarter{1, 2, 3, 0, 0, half, half};
  const Eigen::Isometry3d T = pose_from_numbers(quarter);
  CHECK(T.translation() == Eigen::Vector3d(1, 2, 3));
  CHECK(T.linear().col(0).isApprox(Eigen::Vector3d::UnitY()));
  CHECK_NOTHROW(pose_from_numbers(std::array<double, 7>{0, 0, 0, 0, 0, 0, 1.009}));
  CHECK(error_text([] {
          pose_from_numbers(std::array<double, 7>{0, 0, 0, 0, 0, 0, 2});
        }).find("does not have unit length, but 2.0") != std::string::npos);
  CHECK(error_text([] {
          pose_from_numbers(std::array<double, 7>{0, 0, 0, 0, 0, 0, 0});
        }).find("unit length") != std::string::npos);
  CHECK_THROWS_AS(pose_from_numbers(std::array<double, 7>{std::nan(""), 0, 0, 0, 0, 0, 1}),
                  InvalidValue);
}
