// SPDX-License-Identifier: MIT
#include <cstddef>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/learn_layouts.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

SemanticNode<> standing(int label, double x, double y, double z) {
  SemanticNode<> node;
  node.label = ClassId{label};
  node.position = Eigen::Vector3d(x, y, z);
  return node;
}

TopologyGraph<> furnished_place(std::vector<SemanticNode<>> nodes, bool with_gravity = true) {
  std::optional<Gravity<>> gravity;
  if (with_gravity) gravity = Gravity<>{};  // y points down
  return TopologyGraph<>(std::move(nodes), {}, {}, gravity);
}

struct LearntCounts {
  DistanceCounts level{}, spatial{};
};

LearntCounts counts_of(const LayoutPrior& prior, int first, int second) {
  LearntCounts found;
  prior.for_each(
      [&](ClassId a, ClassId b, const DistanceCounts& level, const DistanceCounts& spatial) {
        if (a == ClassId{first} && b == ClassId{second}) found = {level, spatial};
      });
  return found;
}

double sum_of(const DistanceCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0.0);
}

}  // namespace

TEST_CASE("every place has one vote a pair of classes", "[matching]") {
  // Two chairs and two tables; one chair 3 m above the other.
  const auto place = furnished_place(
      {standing(1, 0, 0, 0), standing(1, 1, -3, 0), standing(2, 0, 0, 2), standing(2, 4, 0, 2)});
  const LayoutPrior once = learn_layouts(std::vector<TopologyGraph<>>{place});
  const LearntCounts chairs = counts_of(once, 1, 1);
  CHECK(chairs.level[DistanceBins::of(1.0)] == 1.0);
  CHECK(chairs.spatial[DistanceBins::of(std::sqrt(10.0))] == 1.0);
  const LearntCounts both = counts_of(once, 1, 2);
  CHECK(sum_of(both.level) == Approx(1.0));
  CHECK(both.level[DistanceBins::of(2.0)] >= 0.25);
  // As often as there are places; the order of the objects does not matter.
  auto nodes = place.nodes();
  std::swap(nodes[0], nodes[3]);
  const LayoutPrior twice =
      learn_layouts(std::vector<TopologyGraph<>>{furnished_place(std::move(nodes))}, once);
  CHECK(sum_of(counts_of(twice, 1, 2).level) == Approx(2.0));
  for (std::size_t bin = 0; bin < DistanceBins::count; ++bin) {
    CHECK(counts_of(twice, 1, 2).spatial[bin] == Approx(2.0 * both.spatial[bin]));
  }
}

TEST_CASE("a place without gravity tells distances in space alone", "[matching]") {
  const LayoutPrior prior = learn_layouts(std::vector<TopologyGraph<>>{
      furnished_place({standing(1, 0, 0, 0), standing(2, 1, 0, 0)}, false)});
  CHECK(sum_of(counts_of(prior, 1, 2).level) == 0.0);
  CHECK(sum_of(counts_of(prior, 1, 2).spatial) == 1.0);
}

TEST_CASE("what has no position or stands far away is passed over; no place at all is refused",
          "[matching]") {
  auto nowhere = standing(2, 0, 0, 0);
  nowhere.position.reset();
  const LayoutPrior prior = learn_layouts(std::vector<TopologyGraph<>>{
      furnished_place({standing(1, 0, 0, 0), nowhere, standing(3, 40, 0, 0)})});
  CHECK(prior.empty());
  CHECK_THROWS_AS(learn_layouts(std::vector<TopologyGraph<>>{}), InvalidValue);
}

TEST_CASE("what stands alike everywhere earns less than what does not", "[matching]") {
  std::mt19937 random(17);
  std::normal_distribution<double> noise(0.0, 0.03);
  std::uniform_real_distribution<double> anywhere(-1.5, 1.5);
  std::vector<TopologyGraph<>> places;
  for (int i = 0; i < 60; ++i) {
    places.push_back(furnished_place({standing(66, noise(random), 0, noise(random)),
                                      standing(64, 0.3 + noise(random), 0, noise(random)),
                                      standing(41, anywhere(random), 0, anywhere(random))}));
  }
  const LayoutPrior prior = learn_layouts(places);
  const auto odds = [&](int label) {
    return prior.log10_odds({ClassId{66}, ClassId{label}},
                            {Eigen::Vector3d::Zero(), {0.3, 0.0, 0.0}}, 1.5, 1.7, true);
  };
  CHECK(odds(64) > odds(41) + 0.3);
}
