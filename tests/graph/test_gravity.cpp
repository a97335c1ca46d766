// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/gravity.hpp>
#include <topobag/graph/local_graph.hpp>

#include "catch.hpp"
#include "graph/flickering_scene.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

constexpr double degree = 0.017453292519943295;

Eigen::Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

/// The direction tilted by `deviation` rad, r.m.s., about each axis across it.
Eigen::Vector3d tilted_by_chance(std::mt19937& random, const Eigen::Vector3d& down,
                                 double deviation) {
  std::normal_distribution<double> angle(0.0, deviation);
  const Eigen::Vector3d u = down.unitOrthogonal(), v = down.cross(u);
  return (down + angle(random) * u + angle(random) * v).normalized();
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

TEST_CASE("down is made a unit vector, whatever its length", "[graph][gravity]") {
  std::mt19937 random(1);
  for (const double length : {9.81, 1.0, 1e-300, 5e-324, 1e300, 0.5}) {
    const Eigen::Vector3d direction(0.0, 0.6, -0.8);
    const Gravity<> gravity = normalized(Gravity<>{length * direction, 0.1});
    CHECK(gravity.down.norm() == Approx(1.0).epsilon(1e-14));
    if (length > 1e-310) CHECK(angle_between(gravity.down, direction) < 1e-12);
    CHECK(gravity.deviation == 0.1);
  }
  for (int trial = 0; trial < 200; ++trial) {
    const Gravity<> once = normalized(Gravity<>{3.0 * random_direction(random), degree});
    CHECK(normalized(once).down == once.down);
    const Gravity<float> as_float = normalized(Gravity<float>{once.down.cast<float>(), 0.1F});
    CHECK(normalized(as_float).down == as_float.down);
  }
  CHECK(Gravity<>{}.deviation == Approx(degree).epsilon(1e-5));
}

TEST_CASE("a gravity that says nothing is refused", "[graph][gravity]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const Gravity<>& bad : {Gravity<>{{0, 0, 0}}, Gravity<>{{0, nan, 0}}, Gravity<>{{inf, 1, 0}},
                               Gravity<>{{0, 1, 0}, 0.0}, Gravity<>{{0, 1, 0}, -0.1},
                               Gravity<>{{0, 1, 0}, nan}, Gravity<>{{0, 1, 0}, inf}}) {
    CHECK_THROWS_AS(normalized(bad), InvalidValue);
    CHECK_THROWS_AS(TopologyGraph<>({}, {}, {}, bad), InvalidValue);
    LocalGraph<> local;
    CHECK_THROWS_AS(local.add(0.0, {}, still, {}, bad), InvalidValue);
    CHECK(local.view_count() == 0);
  }
}

TEST_CASE("a graph keeps its gravity, or that it knows none", "[graph][gravity]") {
  CHECK_FALSE(TopologyGraph<>{}.gravity());
  CHECK_FALSE(TopologyGraph<>({object_at(1, {0, 0, 2})}).gravity());
  const TopologyGraph<> graph = make_topology_graph(std::vector{object_at(1, {0, 0, 2})},
                                                    KnnEdges{}, {}, Gravity<>{{0, 9.81, 0}, 0.02});
  REQUIRE(graph.gravity());
  CHECK(graph.gravity()->down == Eigen::Vector3d::UnitY());
  CHECK(graph.gravity()->deviation == 0.02);
}

TEST_CASE("the surer directions weigh more", "[graph][gravity]") {
  std::mt19937 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector3d down = random_direction(random);
    const Gravity<> sure{tilted_by_chance(random, down, degree), degree};
    const Gravity<> unsure{tilted_by_chance(random, down, degree), 3.0 * degree};
    const Gravity<> fused = *fused_gravity<double>({sure, unsure}, 0.5);
    const double apart = angle_between(sure.down, unsure.down);
    CHECK(fused.down.norm() == Approx(1.0));
    CHECK(angle_between(fused.down, sure.down) == Approx(0.1 * apart).epsilon(0.01));
    CHECK(angle_between(fused.down, unsure.down) == Approx(0.9 * apart).epsilon(0.01));
  }
}

TEST_CASE("the stated deviation is that of directions whose errors are half common",
          "[graph][gravity]") {
  std::mt19937 random(3);
  const std::vector<double> deviations = {0.01, 0.02, 0.01, 0.04};
  double squares = 0.0, stated = 0.0;
  const int trials = 4000;
  for (int trial = 0; trial < trials; ++trial) {
    const Eigen::Vector3d down = random_direction(random);
    std::normal_distribution<double> normal;
    const double common = normal(random), common_too = normal(random);
    const Eigen::Vector3d u = down.unitOrthogonal(), v = down.cross(u);
    std::vector<Gravity<>> directions;
    for (const double deviation : deviations) {
      const double a = std::sqrt(0.5) * (common + normal(random));
      const double b = std::sqrt(0.5) * (common_too + normal(random));
      directions.push_back({(down + deviation * (a * u + b * v)).normalized(), deviation});
    }
    const Gravity<> fused = *fused_gravity(directions, 0.5);
    squares += fused.down.cross(down).squaredNorm() / 2.0;
    stated = fused.deviation;
  }
  CHECK(std::sqrt(squares / trials) == Approx(stated).epsilon(0.04));
}

TEST_CASE("many directions are no surer than what their errors have in common",
          "[graph][gravity]") {
  for (const std::size_t n : {1U, 2U, 10U, 1000U}) {
    const std::vector<Gravity<>> same(n, Gravity<>{{0, 1, 0}, 0.02});
    const double share = 0.5 + 0.5 / static_cast<double>(n);
    CHECK(fused_gravity(same, 0.5)->deviation == Approx(0.02 * std::sqrt(share)));
    CHECK(fused_gravity(same, 0.0)->deviation == Approx(0.02 / std::sqrt(static_cast<double>(n))));
    CHECK(fused_gravity(same, 1.0)->deviation == Approx(0.02));
    CHECK(fused_gravity(same, 0.5)->down == Eigen::Vector3d::UnitY());
  }
  const std::vector<Gravity<>> far_apart = {{{0, 1, 0}, 1e-300}, {{0, 1, 0}, 1e300}};
  CHECK(fused_gravity(far_apart, 0.5)->deviation == Approx(1e-300).epsilon(1e-9));
}

TEST_CASE("directions that contradict each other say nothing", "[graph][gravity]") {
  CHECK_FALSE(fused_gravity<double>({}, 0.5));
  CHECK_FALSE(fused_gravity<double>({{{0, 1, 0}}, {{0, -1, 0}}}, 0.5));
  CHECK_FALSE(fused_gravity<double>({{{0, 1, 0}}, {{1, 0, 0}}, {{0, 0, 1}}, {{0, -1, 0}}}, 0.5));
  CHECK(fused_gravity<double>({{{0, 1, 0}}, {{1, 0, 0}}}, 0.5));
}

TEST_CASE("gravity is carried along by the relative poses", "[graph][gravity]") {
  std::mt19937 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Vector3d down_in_first = random_direction(random);
    LocalGraph<> local;
    CHECK_FALSE(local.gravity());
    local.add(0.0, {}, still, camera_view(), Gravity<>{down_in_first, 0.02});
    CHECK(local.gravity()->down.isApprox(down_in_first, 1e-14));
    Eigen::Isometry3d T_first_newest = still;
    for (int frame = 1; frame < 6; ++frame) {
      const Eigen::Isometry3d step = random_motion(random, 0.5);
      T_first_newest = T_first_newest * step;
      std::optional<Gravity<>> known;
      const Eigen::Vector3d there = T_first_newest.linear().transpose() * down_in_first;
      if (frame == 3) known = Gravity<>{there, 0.02};
      local.add(0.1 * frame, {}, step, camera_view(), known);
      const TopologyGraph<> graph = local.graph();
      REQUIRE(graph.gravity());
      CHECK(graph.gravity()->down.isApprox(there, 1e-9));
      CHECK(graph.gravity()->deviation == Approx(frame < 3 ? 0.02 : 0.02 * std::sqrt(0.75)));
    }
  }
}

TEST_CASE("a local graph's gravity is nearer the truth than a single one", "[graph][gravity]") {
  std::mt19937 random(5);
  double single = 0.0, fused = 0.0;
  for (int trial = 0; trial < 50; ++trial) {
    LocalGraph<> local;
    Eigen::Vector3d down = random_direction(random);
    for (int frame = 0; frame < 20; ++frame) {
      const Eigen::Isometry3d step = random_motion(random, 0.5);
      down = step.linear().transpose() * down;
      const Gravity<> sensed{tilted_by_chance(random, down, degree), degree};
      local.add(0.1 * frame, {}, step, {}, sensed);
      if (frame < 19) continue;
      single += sensed.down.cross(down).squaredNorm();
      fused += local.gravity()->down.cross(down).squaredNorm();
    }
  }
  CHECK(fused < 0.1 * single);
}

TEST_CASE("gravity is forgotten with the window, and comes again", "[graph][gravity]") {
  LocalGraph<> local;
  const Gravity<> down{{0, 1, 0}, 0.02}, forward{{0, 0, 1}, 0.02};
  local.add(0.0, {object_at(1, {0, 0, 2})}, still, {}, down);
  local.add(3.0, {}, still);
  CHECK(local.graph().gravity()->down == down.down);
  local.add(3.1, {}, still);
  CHECK_FALSE(local.graph().gravity());
  local.add(3.2, {}, still, {}, forward);
  CHECK(local.graph().gravity()->down == forward.down);
}
