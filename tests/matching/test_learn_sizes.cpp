// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/learn_sizes.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// Places with chairs whose sizes differ so within and between them.
std::vector<TopologyGraph<>> furnished(std::size_t places, std::size_t chairs, double within,
                                       double between) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::vector<TopologyGraph<>> graphs;
  for (std::size_t place = 0; place < places; ++place) {
    const double model = between * normal(random);
    std::vector<SemanticNode<>> nodes(chairs);
    for (auto& node : nodes) {
      node.label = ClassId{56};
      node.size = {0.5 * std::exp(model + within * normal(random)), 0.8};
    }
    graphs.emplace_back(std::move(nodes));
  }
  return graphs;
}

}  // namespace

TEST_CASE("what differs within places and between them is found again", "[matching]") {
  const SizePrior learnt = learn_sizes(furnished(400, 6, 0.2, 0.4));
  const SizeSpread& spread = learnt.of(ClassId{56});
  CHECK(spread.within[0] == Approx(0.2).epsilon(0.05));
  CHECK(spread.between[0] == Approx(0.4).epsilon(0.1));
  // All are as high; what is believed before counts for ten.
  CHECK(spread.within[1] < 0.02);
  CHECK(spread.between[1] < 0.03);
}

TEST_CASE("a misread box in ten changes little", "[matching]") {
  auto places = furnished(400, 6, 0.2, 0.4);
  for (std::size_t i = 0; i < places.size(); i += 2) {
    auto nodes = places[i].nodes();
    nodes[0].size.x() *= 20.0;
    places[i] = TopologyGraph<>(nodes);
  }
  const SizePrior learnt = learn_sizes(places);
  CHECK(learnt.of(ClassId{56}).within[0] == Approx(0.2).epsilon(0.3));
}

TEST_CASE("few objects leave the prior nearly as it was, unknown classes and sizes quite so",
          "[matching]") {
  SizePrior prior;
  prior.spread = {{0.1, 0.1}, {0.3, 0.3}};
  const SizePrior learnt = learn_sizes(furnished(2, 2, 0.2, 0.4), prior);
  CHECK(learnt.of(ClassId{56}).within[0] == Approx(0.1).margin(0.1));
  CHECK(learnt.of(ClassId{56}).between[0] == Approx(0.3).margin(0.1));
  CHECK(learnt.of(ClassId{57}).within == prior.spread.within);

  std::vector<SemanticNode<>> nodes(1);
  nodes[0].label = ClassId{3};
  const std::vector<TopologyGraph<>> unknown{TopologyGraph<>(nodes), TopologyGraph<>(nodes)};
  CHECK(learn_sizes(unknown, prior).of(ClassId{3}).within == prior.spread.within);
}

TEST_CASE("one place teaches nothing of what places differ in", "[matching]") {
  CHECK_THROWS_AS(learn_sizes(furnished(1, 6, 0.2, 0.4)), InvalidValue);
}
