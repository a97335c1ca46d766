// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <random>

#include "catch.hpp"

#include <topobag/matching/match_graphs.hpp>
#include <topobag/matching/rigid_fit.hpp>
#include <topobag/matching/shared_vertical.hpp>

#include "layouts.hpp"

using namespace topobag;

namespace {

/// The same graph, knowing which way is down, to `deviation` rad.
TopologyGraph<> leveled(const TopologyGraph<>& graph, const Eigen::Vector3d& down,
                        double deviation = 0.01) {
  return TopologyGraph<>(graph.nodes(), graph.edges(), graph.views(),
                         Gravity<>{down.normalized(), deviation});
}

/// The graph moved by a pose, its gravity too.
TopologyGraph<> carried(const TopologyGraph<>& graph, const Eigen::Isometry3d& T_new_old) {
  auto nodes = graph.nodes();
  const Eigen::Matrix3d R = T_new_old.linear();
  for (auto& node : nodes) {
    node.position = T_new_old * *node.position;
    node.covariance = (R * node.covariance * R.transpose()).eval();
  }
  std::optional<Gravity<>> gravity = graph.gravity();
  if (gravity) gravity->down = R * gravity->down;
  return TopologyGraph<>(nodes, {}, {}, gravity);
}

Eigen::Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Vector3d(x, y, z).normalized();
}

}  // namespace

TEST_CASE("a shared vertical takes gravity on both sides", "[matching]") {
  const TopologyGraph<> unknown = grid_graph(4, 2, 0.5);
  const TopologyGraph<> known = leveled(unknown, Eigen::Vector3d::UnitY(), 0.03);
  CHECK_FALSE(shared_vertical(unknown, known));
  CHECK_FALSE(shared_vertical(known, unknown));
  const auto shared = shared_vertical(known, known);
  REQUIRE(shared);
  CHECK(shared->variance == Approx(2 * 0.03 * 0.03));
}

TEST_CASE("level rotations keep the vertical and turn by their yaw", "[matching]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-3.1, 3.1);
  for (int round = 0; round < 200; ++round) {
    const SharedVertical vertical{random_direction(random), random_direction(random), 1e-4};
    const double yaw = any(random);
    const Eigen::Matrix3d R = vertical.rotation(yaw);
    CHECK((R * vertical.source_down - vertical.target_down).norm() < 1e-9);
    CHECK(vertical.tilt(R).norm() < 1e-9);
    CHECK(vertical.yaw(R) == Approx(std::abs(yaw)).margin(1e-6));
  }
}

TEST_CASE("a level fit finds yaw and translation from two points", "[matching]") {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    const Eigen::Vector3d down = random_direction(random);
    const SharedVertical vertical{T.linear() * down, down, 1e-4};
    Eigen::Matrix<double, 3, 2> source = Eigen::Matrix<double, 3, 2>::Random();
    source.col(1) += down.unitOrthogonal();  // not over each other
    const Eigen::Matrix<double, 3, 2> target = T * source;
    const auto fit = fit_level(target, source, vertical);
    REQUIRE(fit);
    CHECK(fit->rms < 1e-9);
    CHECK(fit->T_target_source.isApprox(T, 1e-9));
  }
  CHECK_FALSE(fit_level(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xd(3, 0), SharedVertical{}));
}

TEST_CASE("with gravity two objects give a pose, over each other they leave it open",
          "[matching]") {
  const Eigen::Vector3d down = Eigen::Vector3d::UnitY();
  const auto two = [&](const Eigen::Vector3d& second) {
    return leveled(TopologyGraph<>({object_at(1, {0, 0, 3}), object_at(2, second)}), down);
  };
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(0.7, down));
  const TopologyGraph<> beside = two({0.8, 0.1, 3});
  const GraphMatch match = match_graphs(carried(beside, turn), beside);
  REQUIRE(match.poses.size() >= 1);
  CHECK_FALSE(match.poses.front().degenerate);
  CHECK(match.poses.front().T_candidate_query.isApprox(turn, 1e-3));

  const GraphMatch over = match_graphs(two({0, 0.8, 3}), two({0, 0.8, 3}));
  for (const RelativePose& pose : over.poses) CHECK(pose.degenerate);
}

TEST_CASE("with gravity a layout is not taken for one that is tilted", "[matching][regression]") {
  std::mt19937 random(9);
  const TopologyGraph<> graph = leveled(noisy_graph(random, 6, 6, 0.02), Eigen::Vector3d::UnitY());
  const Eigen::Isometry3d tilt(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX()));
  const TopologyGraph<> tilted = leveled(carried(graph, tilt), Eigen::Vector3d::UnitY());
  REQUIRE_FALSE(match_graphs(graph, graph).poses.empty());
  CHECK(match_graphs(graph, graph).poses.front().inliers.size() == 6);
  for (const RelativePose& pose : match_graphs(tilted, graph).poses) {
    CHECK(pose.inliers.size() < 6);
  }
}

TEST_CASE("gravity makes poses surer, never by less than its own noise", "[matching]") {
  std::mt19937 random(13);
  for (int round = 0; round < 50; ++round) {
    const TopologyGraph<> bare = noisy_graph(random, 5, 5, 0.03);
    const TopologyGraph<> known = leveled(bare, Eigen::Vector3d::UnitY(), 0.01);
    const GraphMatch without = match_graphs(bare, bare), with = match_graphs(known, known);
    REQUIRE_FALSE(without.poses.empty());
    REQUIRE_FALSE(with.poses.empty());
    if (with.poses.front().inliers.size() != 5 || without.poses.front().inliers.size() != 5)
      continue;
    CHECK(with.poses.front().rotation_deviation() <=
          without.poses.front().rotation_deviation() * (1.0 + 1e-6));
  }
}
