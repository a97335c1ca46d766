// SPDX-License-Identifier: MIT
#include <topobag/evaluation/alignment.hpp>
#include <topobag/evaluation/pose_error.hpp>

#include "catch.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;

namespace {

/// The estimate is the truth seen from another world, shrunk by `scale`.
std::vector<PosePair> moved_world(std::mt19937& random, int n, double scale) {
  const Eigen::Isometry3d T = topobag_tests::random_pose(random);
  std::vector<PosePair> pairs;
  for (int i = 0; i < n; ++i) {
    PosePair pair;
    pair.T_true = topobag_tests::random_pose(random);
    pair.T_estimate = T * pair.T_true;
    pair.T_estimate.translation() *= scale;
    pairs.push_back(pair);
  }
  return pairs;
}

double cost(const std::vector<PosePair>& pairs, const Alignment& alignment) {
  double sum = 0.0;
  for (const PosePair& pair : aligned(pairs, alignment)) {
    sum += (pair.T_true.translation() - pair.T_estimate.translation()).squaredNorm();
  }
  return sum;
}

}  // namespace

TEST_CASE("an alignment undoes a change of world and scale", "[evaluation]") {
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const double scale = 0.1 + 0.05 * i;
    const auto pairs = moved_world(random, 3 + i % 20, scale);
    const Alignment alignment = align(pairs, AlignmentModel::sim3);
    CHECK(alignment.scale == Approx(1.0 / scale));
    for (const PosePair& pair : aligned(pairs, alignment)) {
      CHECK(pose_error(pair.T_true, pair.T_estimate).translation_m < 1e-9);
      CHECK(pose_error(pair.T_true, pair.T_estimate).rotation_deg < 1e-6);
    }
  }
}

TEST_CASE("no nearby transform fits noisy positions better", "[evaluation]") {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    const AlignmentModel model = i % 2 == 0 ? AlignmentModel::se3 : AlignmentModel::sim3;
    auto pairs = moved_world(random, 10, 1.0);
    for (PosePair& pair : pairs) {
      pair.T_estimate.translation() += Eigen::Vector3d::NullaryExpr([&] { return normal(random); });
    }
    const Alignment best = align(pairs, model);
    CHECK((best.scale == 1.0) == (model == AlignmentModel::se3));
    CHECK(best.rotation.determinant() == Approx(1.0));
    for (int k = 0; k < 20; ++k) {
      Alignment other = best;
      const Eigen::Vector3d axis = topobag_tests::random_pose(random).translation().normalized();
      other.rotation = Eigen::AngleAxisd(0.01 * normal(random), axis) * other.rotation;
      other.translation += Eigen::Vector3d::NullaryExpr([&] { return 0.01 * normal(random); });
      if (model == AlignmentModel::sim3) other.scale *= 1.0 + 0.01 * normal(random);
      CHECK(cost(pairs, other) >= cost(pairs, best));
    }
  }
}

TEST_CASE("degenerate positions give finite alignments", "[evaluation]") {
  std::mt19937 random(6);
  CHECK(align({}).rotation.isIdentity());
  for (const AlignmentModel model : {AlignmentModel::se3, AlignmentModel::sim3}) {
    for (int n = 1; n <= 3; ++n) {
      // All at one place, then on a line.
      for (const double spread : {0.0, 1.0}) {
        const Eigen::Isometry3d T = topobag_tests::random_pose(random);
        std::vector<PosePair> pairs(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) {
          PosePair& pair = pairs[static_cast<std::size_t>(i)];
          pair.T_true.translation() << spread * i, 1.0, 2.0;
          pair.T_estimate = T * pair.T_true;
        }
        const Alignment alignment = align(pairs, model);
        CHECK(alignment.rotation.isUnitary(1e-9));
        CHECK(alignment.scale == Approx(1.0));
        CHECK(cost(pairs, alignment) < 1e-18);
      }
    }
  }
  CHECK(align(moved_world(random, 9, 1.0), AlignmentModel::none).rotation.isIdentity());
}
