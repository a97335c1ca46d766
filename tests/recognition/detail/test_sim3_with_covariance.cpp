// SPDX-License-Identifier: MIT
#include <topobag/recognition/detail/sim3_with_covariance.hpp>

#include <cmath>
#include <random>

#include <topobag/recognition/detail/alignment_motion.hpp>

#include "catch.hpp"
#include "recognition/drawn_sim3.hpp"

using namespace topobag;
using detail::Sim3WithCovariance;

TEST_CASE("a product of two motions takes points as one after the other", "[recognition]") {
  std::mt19937 random(2220);
  for (int round = 0; round < 50; ++round) {
    const Sim3WithCovariance a_b = drawn_sim3(random), b_c = drawn_sim3(random);
    const Eigen::Vector3d x_c = drawn_zeta(random).head<3>();
    const Eigen::Vector3d x_a = a_b * Eigen::Vector3d(b_c * x_c);
    CHECK(((a_b * b_c) * x_c).isApprox(x_a, 1e-9));
  }
}

TEST_CASE("a motion's adjoint takes errors from its right to its left", "[recognition]") {
  std::mt19937 random(2221);
  for (int round = 0; round < 50; ++round) {
    const Sim3WithCovariance a_b = drawn_sim3(random);
    const Sim3WithCovariance::Vector7 zeta = 1e-5 * drawn_zeta(random);
    Sim3WithCovariance small, left = a_b;
    detail::correct(small, zeta);
    const Sim3WithCovariance::Vector7 moved = a_b.adjoint() * zeta;
    detail::correct(left, moved);
    const Sim3WithCovariance right = a_b * small;
    CHECK(left.scale == Approx(right.scale).epsilon(1e-8));
    CHECK(left.T.isApprox(right.T, 1e-7));
    // So that the covariances of a product are those of its errors.
    Sim3WithCovariance doubtful = small;
    doubtful.covariance = zeta * zeta.transpose();
    CHECK((a_b * doubtful).covariance.isApprox(moved * moved.transpose(), 1e-9));
  }
}

TEST_CASE("pose and scale beside each other err as the motion does", "[recognition]") {
  std::mt19937 random(2222);
  for (int round = 0; round < 50; ++round) {
    const Sim3WithCovariance drawn = drawn_sim3(random);
    const Sim3WithCovariance::Vector7 apart = 1e-5 * drawn_zeta(random);  // ξ, λ
    RelativePose pose;
    pose.T_candidate_query = drawn.T;
    pose.scale = drawn.scale;
    pose.covariance = apart.head<6>() * apart.head<6>().transpose();
    pose.scale_covariance = apart(6) * apart.head<6>();
    pose.scale_deviation = drawn.scale * std::abs(apart(6));
    const Sim3WithCovariance motion = Sim3WithCovariance::of(pose);
    // T_true = Exp(ξ) · T and scale_true = exp(λ) · scale, as one error of the motion.
    PoseWithCovariance<> T_true{drawn.T};
    detail::correct(T_true, Eigen::Matrix<double, 6, 1>(apart.head<6>()));
    const Sim3WithCovariance truth{T_true.T, std::exp(apart(6)) * drawn.scale};
    const Sim3WithCovariance::Vector7 zeta = detail::error_between(truth, motion);
    CHECK(motion.covariance.isApprox(zeta * zeta.transpose(), 1e-3));
    const auto again = motion.of_pose_and_scale();
    CHECK(again.isApprox(apart * apart.transpose(), 1e-9));
  }
}
