// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/sensing/lifted_nodes.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("dropped detections add up over frames", "[sensing]") {
  DroppedDetections sum;
  sum += DroppedDetections{1, 2, 3, 4, 5, 6, 7};
  sum += DroppedDetections{10, 20, 30, 40, 50, 60, 70};
  CHECK(sum.invalid == 11);
  CHECK(sum.low_confidence == 22);
  CHECK(sum.dynamic == 33);
  CHECK(sum.too_large == 44);
  CHECK(sum.no_depth == 55);
  CHECK(sum.out_of_range == 66);
  CHECK(sum.duplicate == 77);
  CHECK(sum.total() == 308);
}

TEST_CASE("a node is dropped when a surer one that stays is the same object", "[sensing]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> metres(0.0, 0.3), size(0.2, 0.6);
  std::size_t dropped = 0, stayed = 0;
  for (int round = 0; round < 300; ++round) {
    LiftedNodes<double> lifted;
    lifted.dropped.dynamic = 5;
    for (std::size_t i = random() % 9; i > 0; --i) {
      SemanticNode<double> node;
      const double x = metres(random), y = metres(random);
      node.position = Eigen::Vector3d(x, y, 2.0);
      node.size = {size(random), 0.3};
      node.confidence = 0.1 * static_cast<double>(random() % 10);  // some are equally sure
      lifted.nodes.push_back(node);
      lifted.sources.push_back(10 + 3 * lifted.sources.size());
    }
    const LiftedNodes<double> given = lifted;
    detail::drop_duplicates(lifted, SameObject{});

    // By the definition: the surest first, of equals the earlier, each asked of all that stayed.
    std::vector<bool> stays(given.nodes.size(), false), asked(given.nodes.size(), false);
    for (std::size_t rank = 0; rank < given.nodes.size(); ++rank) {
      std::size_t next = given.nodes.size();
      for (std::size_t i = 0; i < given.nodes.size(); ++i) {
        const bool surer =
            next == given.nodes.size() || given.nodes[i].confidence > given.nodes[next].confidence;
        if (!asked[i] && surer) next = i;
      }
      asked[next] = stays[next] = true;
      for (std::size_t i = 0; i < given.nodes.size(); ++i) {
        if (i != next && stays[i] && SameObject{}(given.nodes[i], given.nodes[next])) {
          stays[next] = false;
        }
      }
    }
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < stays.size(); ++i) {
      if (stays[i]) expected.push_back(given.sources[i]);
    }
    CHECK(lifted.sources == expected);
    REQUIRE(lifted.nodes.size() == expected.size());
    CHECK(lifted.dropped.duplicate == given.nodes.size() - expected.size());
    CHECK(lifted.dropped.dynamic == 5);
    dropped += lifted.dropped.duplicate;
    stayed += expected.size();
  }
  CHECK(dropped > 100);
  CHECK(stayed > 100);
}
