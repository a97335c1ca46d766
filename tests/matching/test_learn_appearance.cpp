// SPDX-License-Identifier: MIT
#include <random>
#include <vector>

#include <topobag/matching/learn_appearance.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"
#include "random_appearance.hpp"

using namespace topobag;

TEST_CASE("a verified match teaches how alike one object looks, two places how alike two do",
          "[matching][appearance]") {
  std::mt19937 random(1);
  const AppearanceKind kind("random", 16);
  AppearanceCounts counts(kind);
  std::vector<TopologyGraph<>> places;
  for (int round = 0; round < 60; ++round) {
    std::vector<SemanticNode<>> nodes{object_at(1, {0, 0, 3}), object_at(1, {2, 0, 3}),
                                      object_at(2, {0, 2, 3}), object_at(3, {2, 2, 3})};
    for (auto& node : nodes) node.appearance = random_appearance(random, kind);
    const TopologyGraph<> candidate(nodes);
    nodes[3].label = ClassId{4};  // one object by two names says nothing of its class
    RelativePose pose;
    pose.T_candidate_query = random_motion(random, 1.0);
    learn_appearance(counts, candidate,
                     moved(TopologyGraph<>(nodes), pose.T_candidate_query.inverse()), pose);
    places.push_back(candidate);
  }
  CHECK(counts.same() == 60 * 3);
  for (std::size_t i = 1; i < places.size(); ++i) {
    learn_other_appearance(counts, places[i - 1], places[i]);
  }
  CHECK(counts.other() == 59 * 6);  // 2 · 2 of one class, and one of each of two
  const AppearanceModel model = counts.model();
  CHECK(model.log10_odds(places[0].node(node_index(0)).appearance,
                         places[0].node(node_index(0)).appearance) > 0.7);
  CHECK(model.log10_odds(0.0) < -0.8);
}
