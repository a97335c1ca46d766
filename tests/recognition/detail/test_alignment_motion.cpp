// SPDX-License-Identifier: MIT
#include <topobag/recognition/detail/alignment_motion.hpp>

#include <random>

#include "catch.hpp"
#include "recognition/drawn_sim3.hpp"

using namespace topobag;
using detail::Sim3WithCovariance;

TEST_CASE("a motion corrected by its error is the other one", "[recognition]") {
  std::mt19937 random(2230);
  for (int round = 0; round < 50; ++round) {
    const Sim3WithCovariance from = drawn_sim3(random);
    Sim3WithCovariance small, to = from;
    detail::correct(small, Sim3WithCovariance::Vector7(0.02 * drawn_zeta(random)));
    to = small * from;
    Sim3WithCovariance corrected = from;
    for (int iteration = 0; iteration < 4; ++iteration) {
      detail::correct(corrected, detail::error_between(to, corrected));
    }
    CHECK(corrected.scale == Approx(to.scale).epsilon(1e-9));
    CHECK(corrected.T.isApprox(to.T, 1e-9));
    // Of a rigid motion it is that of its pose.
    const PoseWithCovariance<> rigid_to{to.T}, rigid_from{from.T};
    const auto by_seven =
        detail::error_between(Sim3WithCovariance{to.T}, Sim3WithCovariance{from.T});
    const auto by_six = detail::error_between(rigid_to, rigid_from);
    CHECK(by_seven.head<6>().isApprox(by_six, 1e-9));
    CHECK(by_seven(6) == 0.0);
  }
}

TEST_CASE("a point moves with a motion's error as its derivative says", "[recognition]") {
  std::mt19937 random(2231);
  for (int round = 0; round < 50; ++round) {
    const Sim3WithCovariance a_b = drawn_sim3(random);
    const Sim3WithCovariance::Vector7 zeta = 1e-6 * drawn_zeta(random);
    const Eigen::Vector3d x_b = drawn_zeta(random).head<3>(), x_a = a_b * x_b;
    Sim3WithCovariance erred = a_b;
    detail::correct(erred, zeta);
    const Eigen::Vector3d moved = erred * x_b - x_a;
    CHECK((detail::moved_by_error(a_b, x_a) * zeta).isApprox(moved, 1e-4));
  }
}

TEST_CASE("a camera of the other map stands where its points do", "[recognition]") {
  std::mt19937 random(2232);
  for (int round = 0; round < 50; ++round) {
    const Sim3WithCovariance a_b = drawn_sim3(random), drawn = drawn_sim3(random);
    const Eigen::Isometry3d T_a_camera = detail::camera_in(a_b, drawn.T);
    const Eigen::Vector3d seen = drawn_zeta(random).head<3>();  // in the camera, b's unit
    CHECK((T_a_camera * (a_b.scale * seen)).isApprox(a_b * Eigen::Vector3d(drawn.T * seen), 1e-9));
    const PoseWithCovariance<> rigid{a_b.T};
    CHECK(detail::camera_in(rigid, drawn.T).isApprox(a_b.T * drawn.T));
  }
}
