// SPDX-License-Identifier: MIT
#include <random>

#include <topobag/adaptors/orb_slam/host_pose.hpp>

#include "adaptors/small_host.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("poses of cv::Mat's and of Sophus' kind are read alike", "[adaptors]") {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Isometry3d T = random_camera(random);
    const small_host::Pose as_mat{T.matrix().cast<float>()};
    const Eigen::Isometry3f as_sophus(T.cast<float>());
    CHECK(host_pose(as_mat).isApprox(T, 1e-6));
    CHECK(host_pose(as_sophus).isApprox(T, 1e-6));
    const Eigen::Matrix3d R = host_pose(as_mat).linear();
    CHECK((R * R.transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-14));
  }
}

TEST_CASE("a host's pose that is no rigid motion is refused", "[adaptors]") {
  Eigen::Matrix4f scaled = Eigen::Matrix4f::Identity();
  scaled.topLeftCorner<3, 3>() *= 0.1F;  // a Sim(3), as after a monocular loop
  CHECK_THROWS_AS(host_pose(small_host::Pose{scaled}), InvalidValue);
  CHECK_THROWS_AS(host_pose(small_host::Pose{Eigen::Matrix4f::Zero()}), InvalidValue);
  CHECK_THROWS_AS(host_pose(Eigen::Isometry3f(Eigen::Scaling(1.0F, 1.0F, -1.0F))), InvalidValue);
}

TEST_CASE("a plain pose is the matrix row by row", "[adaptors]") {
  Eigen::Isometry3d T(Eigen::Translation3d(1.0, 2.0, 3.0) *
                      Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()));
  const PlainPose plain = plain_pose(T);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      CHECK(plain[static_cast<std::size_t>(4 * row + column)] ==
            static_cast<float>(T.matrix()(row, column)));
    }
  }
}
