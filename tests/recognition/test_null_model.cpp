// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>
#include <vector>

#include <topobag/recognition/null_model.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

std::vector<double> sorted_along(const TopologyGraph<>& graph, Eigen::Index axis) {
  std::vector<double> values;
  for (const auto& node : graph.nodes()) {
    if (node.position) values.push_back((*node.position)(axis));
  }
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace

TEST_CASE("a permuted layout has the same objects, heights and coordinates", "[recognition]") {
  std::mt19937 random(1);
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const TopologyGraph<> graph = random_graph(random, seed % 12, 4, false);
    const TopologyGraph<> layout = permuted_layout(graph, seed);
    REQUIRE(layout.size() == graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const auto &was = graph.nodes()[i], &is = layout.nodes()[i];
      CHECK(is.label == was.label);
      CHECK(is.size == was.size);
      REQUIRE(is.position.has_value() == was.position.has_value());
      if (is.position) CHECK(is.position->y() == was.position->y());
    }
    for (const Eigen::Index axis : {0, 1, 2}) {
      CHECK(sorted_along(layout, axis) == sorted_along(graph, axis));
    }
  }
}

TEST_CASE("a seed gives one layout, another seed another", "[recognition]") {
  std::mt19937 random(2);
  const TopologyGraph<> graph = random_graph(random, 10);
  const auto places = [&](std::uint32_t seed) {
    std::vector<double> numbers;
    const TopologyGraph<> layout = permuted_layout(graph, seed);
    for (const auto& node : layout.nodes()) {
      numbers.insert(numbers.end(), node.position->data(), node.position->data() + 3);
    }
    return numbers;
  };
  CHECK(places(1) == places(1));
  CHECK(places(1) != places(2));
}

TEST_CASE("a permuted layout that knows the vertical keeps it, and every height along it",
          "[recognition]") {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Eigen::Vector3d down =
        Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    const TopologyGraph<> loose = random_graph(random, 3 + seed % 9, 4, false);
    const TopologyGraph<> graph(loose.nodes(), {}, {}, Gravity<>{down});
    const TopologyGraph<> layout = permuted_layout(graph, seed);
    REQUIRE(layout.gravity());
    CHECK(layout.gravity()->down == down);
    const auto mean = [](const TopologyGraph<>& of) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const auto& node : of.nodes()) {
        if (node.position) sum += *node.position;
      }
      return sum;
    };
    CHECK((mean(layout) - mean(graph)).norm() < 1e-9);
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const auto &was = graph.nodes()[i], &is = layout.nodes()[i];
      if (was.position) {
        CHECK(is.position->dot(down) == Approx(was.position->dot(down)).margin(1e-9));
      }
    }
  }
}
