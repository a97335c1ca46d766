// SPDX-License-Identifier: MIT
#include <random>

#include <topobag/matching/learn_confusion.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

TEST_CASE("what a detector confuses is learnt from where the objects are", "[matching]") {
  std::mt19937 random(72);
  ClassConfusion confusion;
  std::size_t flipped = 0, seen = 0;
  for (int round = 0; round < 400; ++round) {
    RelativePose pose;
    pose.T_candidate_query = random_motion(random, 1.0);
    std::vector<SemanticNode<>> nodes{object_at(1, {0, 0, 3}), object_at(1, {2, 0, 3}),
                                      object_at(2, {0, 2, 3})};
    const TopologyGraph<> candidate(nodes);
    for (std::size_t i = 0; i < 2; ++i) {
      ++seen;
      if (random() % 5 != 0) continue;  // one 1 in five is taken for a 3
      nodes[i].label = ClassId{3};
      ++flipped;
    }
    const TopologyGraph<> query = moved(TopologyGraph<>(nodes), pose.T_candidate_query.inverse());
    learn_confusion(confusion, candidate, query, pose);
  }
  const double share = static_cast<double>(flipped) / static_cast<double>(seen);
  CHECK(confusion.probability(ClassId{1}, ClassId{3}) == Approx(share).epsilon(0.05));
  CHECK(confusion.probability(ClassId{2}, ClassId{2}) > 0.99);
  CHECK(confusion.groups(0.1).compatible(ClassId{1}, ClassId{3}));
  CHECK_FALSE(confusion.groups(0.1).compatible(ClassId{1}, ClassId{2}));
}
