// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <topobag/matching/chance_model.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

/// A graph of nodes of these classes, strewn.
TopologyGraph<> with_classes(const std::vector<int>& labels) {
  std::mt19937 random(81);
  auto nodes = random_nodes(random, labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    nodes[i].label = ClassId{labels[i]};
    nodes[i].covariance = 4e-4 * Eigen::Matrix3d::Identity();
  }
  return TopologyGraph<>(std::move(nodes));
}

std::vector<Correspondence> first_pairs(std::size_t count) {
  std::vector<Correspondence> pairs;
  for (std::size_t i = 0; i < count; ++i) pairs.push_back({node_index(i), node_index(i)});
  return pairs;
}

/// Significance of pairing the first `count` nodes of both, the query's places all `residual` m
/// off, this way and that.
double significance(const TopologyGraph<>& candidate, const TopologyGraph<>& query,
                    std::size_t count, double residual = 0.0, const ClassGroups& groups = {}) {
  std::vector<PointPair> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& p = candidate.nodes()[i];
    const auto& q = query.nodes()[i];
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    points.push_back({*p.position, *p.position + side * Eigen::Vector3d(residual, 0, 0),
                      p.covariance, q.covariance});
  }
  const RefinedPose pose = refine_pose(Eigen::Isometry3d::Identity(), points);
  return ChanceModel{}.significance(candidate, query, first_pairs(count), points, pose, groups);
}

}  // namespace

TEST_CASE("the ways to choose the pairs, counted by hand", "[matching]") {
  const TopologyGraph<> candidate = with_classes({1, 1, 1, 2, 2, 3});
  const TopologyGraph<> query = with_classes({1, 1, 2, 2, 2, 4});
  // Class 1: C(3,2) C(2,2) 2! = 6, and 0 to 2 may match: 18. Class 2: C(2,1) C(3,1) 1! = 6: 18.
  // Classes 3 and 4 are in one graph each: one way.
  const std::vector<Correspondence> pairs{{node_index(0), node_index(0)},
                                          {node_index(1), node_index(1)},
                                          {node_index(3), node_index(2)}};
  CHECK(ChanceModel::log10_ways(candidate, query, pairs, {}) == Approx(std::log10(18.0 * 18.0)));
  // No pairs: 3 values for class 1, 3 for class 2.
  CHECK(ChanceModel::log10_ways(candidate, query, {}, {}) == Approx(std::log10(9.0)));

  ClassGroups groups;
  groups.join(ClassId{1}, ClassId{2});
  // One group of five in each: C(5,3)² 3! = 600, and 0 to 5 may match.
  CHECK(ChanceModel::log10_ways(candidate, query, pairs, groups) == Approx(std::log10(3600.0)));
}

TEST_CASE("nodes without a position are no choice", "[matching]") {
  auto nodes = with_classes({1, 1, 1}).nodes();
  nodes[2].position.reset();
  const TopologyGraph<> graph(nodes);
  // C(2,2)² 2! = 2, and 0 to 2 may match.
  CHECK(ChanceModel::log10_ways(graph, graph, first_pairs(2), {}) == Approx(std::log10(6.0)));
}

TEST_CASE("fewer than three pairs say nothing", "[matching]") {
  const TopologyGraph<> graph = with_classes({1, 2, 3, 4});
  for (const std::size_t count : {0U, 1U, 2U}) CHECK(significance(graph, graph, count) == 0.0);
  CHECK(significance(graph, graph, 3) != 0.0);
}

TEST_CASE("each further exact pair makes chance less likely", "[matching]") {
  const TopologyGraph<> graph = with_classes({1, 2, 3, 4, 5, 6, 7, 8});
  for (std::size_t count = 4; count <= 8; ++count) {
    CHECK(significance(graph, graph, count) > significance(graph, graph, count - 1));
  }
}

TEST_CASE("clutter makes chance more likely", "[matching]") {
  std::vector<int> labels{1, 1, 2, 3};
  double last = significance(with_classes(labels), with_classes(labels), 4);
  for (int more = 0; more < 4; ++more) {
    labels.push_back(1);
    const double now = significance(with_classes(labels), with_classes(labels), 4);
    CHECK(now < last);
    last = now;
  }
}

TEST_CASE("larger residuals make chance more likely", "[matching]") {
  const TopologyGraph<> graph = with_classes({1, 2, 3, 4, 5, 6});
  double last = significance(graph, graph, 6);
  for (const double residual : {0.01, 0.02, 0.05, 0.1}) {
    const double now = significance(graph, graph, 6, residual);
    CHECK(now < last);
    last = now;
  }
}

TEST_CASE("a pair of two classes of one group costs its relabelling", "[matching]") {
  const TopologyGraph<> candidate = with_classes({1, 2, 3, 4});
  const TopologyGraph<> same = with_classes({1, 2, 3, 4}), other = with_classes({1, 2, 3, 5});
  ClassGroups groups;
  groups.join(ClassId{4}, ClassId{5});
  CHECK(significance(candidate, same, 4, 0.0, groups) -
            significance(candidate, other, 4, 0.0, groups) ==
        Approx(ChanceModel{}.relabeling));
}

TEST_CASE("the Bayes factor, worked out by hand", "[matching]") {
  // Four corners of a tetrahedron: their variance is 1 along any axis, the sides of the area √12.
  const std::vector<Eigen::Vector3d> corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const double variance = 0.01;  // of a residual
  const Eigen::Matrix3d half = 0.5 * variance * Eigen::Matrix3d::Identity();
  std::vector<PointPair> points;
  for (const auto& corner : corners) points.push_back({corner, corner, half, half});
  const RefinedPose pose = refine_pose(Eigen::Isometry3d::Identity(), points);

  const double pi = std::acos(-1.0), area = 1.5 * 12.0;
  const double density = std::pow(2.0 * pi * variance, -1.5);
  // Translation: variance / 4 per axis; rotation: Σ over corners of y² + z² = 8, variance / 8.
  const double posterior =
      std::pow(2.0 * pi, 3.0) * std::pow(variance / 4.0, 1.5) * std::pow(variance / 8.0, 1.5);
  // Chance: anywhere on the area, heights about a plane that it may lift and tilt as it likes.
  const double height = variance + 0.15 * 0.15;
  const double plane = std::pow(2.0 * pi * height / 4.0, 1.5);
  const double factor =
      std::pow(area * density * std::sqrt(2.0 * pi * height), 4.0) * posterior / (area * 2.0 * pi);
  CHECK(ChanceModel{}.log10_bayes_factor(points, pose) == Approx(std::log10(factor / plane)));

  // With gravity the tilt is known to 0.02 rad, and chance may lift alone. The rotation about the
  // two level axes: 8 / variance and 1 / 0.0004.
  const SharedVertical vertical{Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitY(), 0.0004};
  const RefinedPose level =
      refine_pose(Eigen::Isometry3d::Identity(), points, RefineOptions{}, vertical);
  const double level_posterior = std::pow(2.0 * pi, 3.0) * std::pow(variance / 4.0, 1.5) *
                                 std::sqrt(variance / 8.0) / (8.0 / variance + 1.0 / 0.0004);
  const double level_factor = std::pow(area * density * std::sqrt(2.0 * pi * height), 4.0) *
                              level_posterior / (area * 2.0 * pi * 2.0 * pi * 0.0004) /
                              std::sqrt(2.0 * pi * height / 4.0);
  CHECK(ChanceModel{}.log10_bayes_factor(points, level, vertical) ==
        Approx(std::log10(level_factor)));
}

TEST_CASE("width and height speak apart: a turned box is another object", "[matching]") {
  const TopologyGraph<> graph = with_classes({1, 2, 3, 4});
  auto nodes = graph.nodes();
  for (auto& node : nodes) node.size = {0.1, 0.4};
  auto turned = nodes;
  for (auto& node : turned) node.size = {0.4, 0.1};
  const TopologyGraph<> upright(nodes);
  CHECK(significance(TopologyGraph<>(turned), upright, 4) < significance(upright, upright, 4));
}

TEST_CASE("equal sizes speak for a match, unequal ones against it", "[matching]") {
  const TopologyGraph<> graph = with_classes({1, 2, 3, 4});
  auto nodes = graph.nodes();
  for (auto& node : nodes) node.size *= 2.0;
  CHECK(significance(graph, TopologyGraph<>(nodes), 4) < significance(graph, graph, 4));
}

TEST_CASE("a pose without a proper covariance is no match, and its score a number",
          "[matching][regression]") {
  const TopologyGraph<> graph = with_classes({1, 2, 3, 4});
  const auto pairs = first_pairs(4);
  std::vector<PointPair> points;
  for (const auto& node : graph.nodes()) points.push_back(point_pair(node, node));
  RefinedPose pose = refine_pose(Eigen::Isometry3d::Identity(), points);
  pose.covariance(5, 5) = -1.0;
  const double significance = ChanceModel{}.significance(graph, graph, pairs, points, pose);
  CHECK(std::isfinite(significance));
  CHECK(significance < -1e6);
}

TEST_CASE("pairs that nobody can choose have no significance", "[matching][regression]") {
  const TopologyGraph<> cups = with_classes({1, 1, 1, 1}), books = with_classes({2, 2, 2, 2});
  CHECK_THROWS_AS(significance(cups, books, 3), InvalidValue);  // of no common group
  auto twice = first_pairs(4);
  for (Correspondence& pair : twice) pair.query = node_index(0);
  twice.push_back(twice.back());
  CHECK_THROWS_AS(ChanceModel::log10_ways(cups, cups, twice, ClassGroups{}), InvalidValue);
  ClassGroups alike;
  alike.join(ClassId{1}, ClassId{2});
  CHECK(std::isfinite(significance(cups, books, 3, 0.0, alike)));
}

TEST_CASE("a layout that other places have as well is less significant than one that they have not",
          "[matching]") {
  const TopologyGraph<> graph = with_classes({1, 2, 3, 4});
  const auto pairs = first_pairs(4);
  std::vector<PointPair> points;
  for (const auto& node : graph.nodes()) points.push_back(point_pair(node, node));
  const RefinedPose pose = refine_pose(Eigen::Isometry3d::Identity(), points);
  const auto of = [&](const ChanceModel& chance) {
    return chance.significance(graph, graph, pairs, points, pose);
  };
  ChanceModel usual, unusual;
  usual.layouts.emplace();
  unusual.layouts.emplace();
  for (int a = 1; a <= 4; ++a) {
    for (int b = 1; b < a; ++b) {
      const auto& from = *graph.nodes()[static_cast<std::size_t>(a - 1)].position;
      const auto& to = *graph.nodes()[static_cast<std::size_t>(b - 1)].position;
      DistanceCounts so{}, nearer{};
      so[DistanceBins::of((from - to).norm())] = 100.0;
      nearer[0] = 100.0;
      usual.layouts->add(ClassId{a}, ClassId{b}, {}, so);
      unusual.layouts->add(ClassId{a}, ClassId{b}, {}, nearer);
    }
  }
  CHECK(of(usual) < of(ChanceModel{}));
  CHECK(of(ChanceModel{}) < of(unusual));
  // However unusual, a share of all objects stands anywhere.
  CHECK(of(unusual) <= of(ChanceModel{}) - 3.0 * std::log10(unusual.layouts->even) + 1e-9);
}
