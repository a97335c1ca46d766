// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <topobag/matching/detail/point_sets.hpp>
#include <topobag/matching/detail/scale_fit.hpp>
#include <topobag/matching/refine_pose.hpp>
#include <topobag/matching/rigid_fit.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

/// Points of a pose, with noise, whose source is too small by `log_scale`.
std::vector<PointPair> scaled_pairs(std::mt19937& random, const Eigen::Isometry3d& T,
                                    double log_scale) {
  std::uniform_real_distribution<double> metres(-1.0, 1.0);
  std::normal_distribution<double> normal;
  std::vector<PointPair> pairs;
  for (int i = 0; i < 7; ++i) {
    const double x = metres(random), y = metres(random), z = metres(random);
    const double a = normal(random), b = normal(random), c = normal(random);
    PointPair pair{};
    pair.source = std::exp(-log_scale) * Eigen::Vector3d(x, y, 3.0 + z);
    pair.target = T * Eigen::Vector3d(x, y, 3.0 + z) + 0.02 * Eigen::Vector3d(a, b, c);
    pair.target_covariance = pair.source_covariance = random_covariance(random, 0.02);
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

TEST_CASE("a scale's variance and its pull on the pose are those of the seven normal equations",
          "[matching]") {
  std::mt19937 random(2207);
  RefineOptions options;
  options.kernel_width = 1e6;  // no kernel, so that they can be worked out from the residuals alone
  options.iterations = 50;
  options.tolerance = 1e-12;
  for (int round = 0; round < 50; ++round) {
    const auto pairs = scaled_pairs(random, random_motion(random, 1.0), 0.0);
    const Eigen::Isometry3d T = refined_motion(random_motion(random, 0.0), pairs, options);
    const auto covariance = pose_covariance(T, pairs, options);
    const detail::ScaleFit fit(T, covariance, pairs, options);
    Eigen::Matrix<double, 7, 7> H = Eigen::Matrix<double, 7, 7>::Zero();
    Eigen::Matrix<double, 7, 1> g = Eigen::Matrix<double, 7, 1>::Zero();
    for (const PointPair& pair : pairs) {
      Eigen::Matrix<double, 3, 7> J;
      const double h = 1e-6;
      for (Eigen::Index k = 0; k < 7; ++k) {
        const auto at = [&](double sign) -> Eigen::Vector3d {
          const double x = sign * h;
          if (k == 6) return T * (std::exp(x) * pair.source);
          const Eigen::Vector3d moved = T * pair.source;
          if (k < 3) return moved + x * Eigen::Vector3d::Unit(k);
          return Eigen::AngleAxisd(x, Eigen::Vector3d::Unit(k - 3)) * moved;
        };
        J.col(k) = (at(1.0) - at(-1.0)) / (2.0 * h);
      }
      const Eigen::Matrix3d W = pair.covariance(T).inverse();
      H += J.transpose() * W * J;
      g += J.transpose() * W * pair.residual(T);
    }
    const Eigen::Matrix<double, 7, 7> inverse = H.inverse();
    CHECK(fit.variance == Approx(inverse(6, 6)).epsilon(1e-3));
    CHECK(fit.step == Approx((inverse * g)(6)).margin(0.01 * std::sqrt(fit.variance)));
    const Eigen::Matrix<double, 6, 1> pulled = fit.variance * fit.lever;
    CHECK(pulled.isApprox(inverse.col(6).head<6>(), 1e-3));
    // The determinant of all seven is that of the pose at its scale times this variance.
    CHECK(std::log(covariance.determinant() * fit.variance) ==
          Approx(std::log(inverse.determinant())).margin(0.01));
  }
}

TEST_CASE("the step of a scale goes to where the distances fit", "[matching]") {
  std::mt19937 random(2208);
  std::uniform_real_distribution<double> log_scale(-0.1, 0.1);
  for (int round = 0; round < 50; ++round) {
    const double truth = log_scale(random);
    auto pairs = scaled_pairs(random, random_motion(random, 1.0), truth);
    double found = 0.0;
    for (int i = 0; i < 4; ++i) {
      const detail::PointSets sets(pairs);
      const auto start = fit_rigid(sets.target, sets.source, sets.weights)->T_target_source;
      const RefinedPose pose = refine_pose(start, pairs);
      const detail::ScaleFit fit(pose.T_target_source, pose.covariance, pairs, {});
      found += fit.step;
      for (PointPair& pair : pairs) pair.source *= std::exp(fit.step);
    }
    CHECK(found == Approx(truth).margin(0.05));
  }
}

TEST_CASE("of a single spot no scale can be told", "[matching]") {
  std::vector<PointPair> pairs(4);
  for (PointPair& pair : pairs) {
    pair.source = pair.target = {0.0, 0.0, 2.0};
    pair.target_covariance = pair.source_covariance = 1e-4 * Eigen::Matrix3d::Identity();
  }
  const Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const detail::ScaleFit fit(T, pose_covariance(T, pairs), pairs, {});
  CHECK(fit.variance > 100.0);
}
