// SPDX-License-Identifier: MIT
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/edges/knn_edges.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "bag/saved_bags.hpp"
#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

namespace saved_maps {

/// What a camera in the room sees of it, but for the last `unseen` objects; it would have shown all.
TopologyGraph<> seen_partly(const SyntheticRoom& room, const Eigen::Isometry3d& T_room_camera,
                            std::size_t unseen, double wall) {
  std::vector<SemanticNode<>> nodes = room.seen_from(T_room_camera).nodes();
  nodes.resize(nodes.size() - unseen);
  View<> view;
  view.camera = {300.0, 300.0, 319.5, 239.5, 640, 480};
  view.depth.emplace([&](const Eigen::Vector2d&) { return std::make_optional(wall); }, 640, 480);
  return make_topology_graph(std::move(nodes), KnnEdges{}, {view});
}

/// A map whose numbers are such as its file keeps, and what is asked of it.
struct Visits {
  BagOfTopologyGraphs<> map;
  std::vector<TopologyGraph<>> queries;
};

Visits some_visits() {
  std::mt19937 random(11);
  Visits visits;
  for (unsigned i = 0; i < 24; ++i) {
    const SyntheticRoom room(i, 9, 5);
    const Eigen::Isometry3d camera = random_camera(random);
    const TopologyGraph<> seen = seen_partly(room, camera, i % 7, 4.0 + i % 3);
    visits.map.add(KeyframeId{i}, decode(encode(seen)),
                   standing_at(Eigen::Translation3d(100.0 * i, 0.0, 0.0) * camera));
    visits.queries.push_back(seen_partly(room, random_camera(random), i % 2, 8.0));
  }
  return visits;
}

}  // namespace saved_maps

TEST_CASE("a map decides the same after it was saved and loaded", "[recognition]") {
  const saved_maps::Visits visits = saved_maps::some_visits();
  const BagOfTopologyGraphs<> back = loaded(saved(visits.map));
  const Relocalizer live(visits.map), reloaded(back);
  std::size_t recognised = 0, refused = 0, missing = 0;
  for (const TopologyGraph<>& query : visits.queries) {
    const Recognition before = live.localize(query), after = reloaded.localize(query);
    before ? ++recognised : ++refused;
    REQUIRE(before.candidates.size() == after.candidates.size());
    for (std::size_t i = 0; i < before.candidates.size(); ++i) {
      const CandidateReport &a = before.candidates[i], &b = after.candidates[i];
      CHECK(a.id == b.id);
      CHECK(a.verdict == b.verdict);
      CHECK(a.similarity == b.similarity);
      REQUIRE(a.pose.has_value() == b.pose.has_value());
      if (!a.pose) continue;
      CHECK(a.score() == b.score());
      CHECK(a.pose->T_candidate_query.matrix() == b.pose->T_candidate_query.matrix());
      CHECK(a.pose->covariance == b.pose->covariance);
      CHECK(a.pose->missing.size() == b.pose->missing.size());
      missing += a.pose->missing.size();
    }
  }
  CHECK(recognised > 0);
  CHECK(refused > 0);
  CHECK(missing > 0);
}

TEST_CASE("a map that is saved without its views lets pass what they speak against",
          "[recognition]") {
  const saved_maps::Visits visits = saved_maps::some_visits();
  SaveOptions options;
  options.views = ViewSection::left_out;
  const BagOfTopologyGraphs<> back = loaded(saved(visits.map, options));
  const Relocalizer live(visits.map), blind(back);
  std::size_t only_blind = 0;
  for (const TopologyGraph<>& query : visits.queries) {
    const Recognition before = live.localize(query), after = blind.localize(query);
    if (before) {
      REQUIRE(after);
      CHECK(after.accepted->score() >= before.accepted->score());
    } else if (after) {
      ++only_blind;
    }
  }
  CHECK(only_blind > 0);
}
