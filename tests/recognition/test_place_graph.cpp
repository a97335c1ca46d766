// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Cholesky>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/matching/judge_pose.hpp>
#include <topobag/recognition/place_graph.hpp>
#include <topobag/recognition/place_options.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

namespace {

const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();  // a camera

/// Every second object of what a camera sees, beginning with the first or the second.
TopologyGraph<> half_of(const TopologyGraph<>& graph, std::size_t first) {
  std::vector<SemanticNode<>> nodes;
  for (std::size_t i = first; i < graph.size(); i += 2) nodes.push_back(graph.nodes()[i]);
  return TopologyGraph<>(std::move(nodes));
}

/// A bag that does not tell which cameras stand in a region.
struct QueriedBag {
  using Graph = TopologyGraph<>;
  const BagOfTopologyGraphs<>& bag;

  std::vector<Candidate> query(const Graph& graph, const QueryOptions& options) const {
    return bag.query(graph, options);
  }
  std::optional<Graph> find(KeyframeId id) const { return bag.find(id); }
  std::optional<EntryInfo> info(KeyframeId id) const { return bag.info(id); }
};

}  // namespace

TEST_CASE("a place holds the objects of all key frames around, in the candidate's frame",
          "[recognition]") {
  std::mt19937 random(2);
  const SyntheticRoom room(3, 10, 10);
  BagOfTopologyGraphs<> bag;
  const Eigen::Isometry3d a = random_camera(random), b = random_camera(random);
  bag.add(KeyframeId{1}, half_of(room.seen_from(a), 0), standing_at(a));
  bag.add(KeyframeId{2}, half_of(room.seen_from(b), 1), standing_at(b));
  const Eigen::Isometry3d q = random_camera(random);
  const TopologyGraph<> query = room.seen_from(q), candidate = *bag.find(KeyframeId{1});
  const TopologyGraph<> place = place_graph(bag, KeyframeId{1}, candidate, query, a.inverse() * q);
  REQUIRE(place.size() == 10);
  const TopologyGraph<> whole = room.seen_from(a);
  for (const auto& node : whole.nodes()) {
    bool there = false;
    for (const auto& other : place.nodes()) {
      there =
          there || (other.label == node.label && (*other.position - *node.position).norm() < 1e-6);
    }
    CHECK(there);
  }
}

TEST_CASE("a place is the same whether the bag tells its region or is queried", "[recognition]") {
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 5; ++seed) {
    std::mt19937 random(seed);
    const SyntheticRoom room(3, 10, 10);
    BagOfTopologyGraphs<> bag;
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Eigen::Isometry3d camera = random_camera(random);
      EntryInfo info = standing_at(camera);
      info.session = static_cast<std::uint32_t>(i % 3);
      if (i % 5 == 0) info.T_world_camera.reset();
      bag.add(KeyframeId{i}, half_of(room.seen_from(camera), i % 2), info);
    }
    const TopologyGraph<> query = room.seen_from(random_camera(random));
    PlaceOptions options;
    options.radius = 0.5 + 0.5 * seed;
    QueryOptions retrieval;
    if (seed % 2 == 0) retrieval.among.sessions = {0, 1};
    const auto neighbors = [&](const auto& of_bag) {
      std::vector<Eigen::Vector3d> stands;
      const auto known = bag.info(KeyframeId{1});
      for (const auto& neighbor : detail::neighbors_by_pose(of_bag, KeyframeId{1}, *known, here,
                                                            query, retrieval, options)) {
        stands.push_back(neighbor.T_candidate_neighbor.translation());
      }
      return stands;
    };
    CHECK(neighbors(bag) == neighbors(QueriedBag{bag}));
    found += neighbors(bag).size();
  }
  CHECK(found > 10);
}

TEST_CASE("what the query does not look at is no part of its place", "[recognition]") {
  SemanticNode<> near, far;
  near.label = ClassId{1};
  near.position = Eigen::Vector3d(0, 0, 3);
  near.size = {0.2, 0.2};
  far = near;
  far.position = Eigen::Vector3d(2.5, 0, 3);
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{1}, TopologyGraph<>({near, far}), standing_at(here));
  bag.add(KeyframeId{2}, TopologyGraph<>({near, far}), standing_at(here, 1));
  const TopologyGraph<> query({near});
  const TopologyGraph<> place =
      place_graph(bag, KeyframeId{1}, *bag.find(KeyframeId{1}), query, here);
  REQUIRE(place.size() == 1);
  CHECK((*place.nodes()[0].position - *near.position).norm() < 1e-9);
}

TEST_CASE("key frames far away, or not admitted, are no part of a place", "[recognition]") {
  const SyntheticRoom room(3, 10, 10);
  const TopologyGraph<> seen = room.seen_from(here);
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{1}, half_of(seen, 0), standing_at(here));
  bag.add(KeyframeId{2}, half_of(seen, 1),
          standing_at(Eigen::Isometry3d(Eigen::Translation3d(9, 0, 0))));
  bag.add(KeyframeId{3}, half_of(seen, 1), standing_at(here, 1));
  QueryOptions only_first_two;
  only_first_two.among.max_id = KeyframeId{2};
  const TopologyGraph<> candidate = *bag.find(KeyframeId{1});
  CHECK(place_graph(bag, KeyframeId{1}, candidate, seen, here, only_first_two).size() == 5);
  CHECK(place_graph(bag, KeyframeId{1}, candidate, seen, here).size() == 10);
}

TEST_CASE("without poses the neighbours by id are placed by matching them", "[recognition]") {
  std::mt19937 random(4);
  const SyntheticRoom room(5, 12, 12);
  BagOfTopologyGraphs<> bag;
  const Eigen::Isometry3d a = random_camera(random), b = random_camera(random);
  std::vector<SemanticNode<>> first = room.seen_from(a).nodes();
  const SemanticNode<> unseen = first.back();
  first.pop_back();
  bag.add(KeyframeId{10}, TopologyGraph<>(first));
  bag.add(KeyframeId{11}, room.seen_from(b));
  const TopologyGraph<> candidate = *bag.find(KeyframeId{10});
  const TopologyGraph<> place =
      place_graph(bag, KeyframeId{10}, candidate, room.seen_from(a), here);
  REQUIRE(place.size() == 12);
  bool there = false;
  for (const auto& node : place.nodes()) {
    there =
        there || (node.label == unseen.label && (*node.position - *unseen.position).norm() < 0.05);
  }
  CHECK(there);
}

TEST_CASE("another place that fits as well refuses a match, and is named", "[recognition]") {
  const SyntheticRoom room(6, 9, 5);
  const TopologyGraph<> seen = room.seen_from(here);
  const auto look_up = [&](const Eigen::Isometry3d& T_second) {
    Relocalizer<> relocalizer;
    relocalizer.map().add(KeyframeId{1}, seen, standing_at(here));
    relocalizer.map().add(KeyframeId{2}, seen, standing_at(T_second));
    return relocalizer.localize(seen);
  };
  const Recognition twins = look_up(Eigen::Isometry3d(Eigen::Translation3d(50, 0, 0)));
  CHECK_FALSE(twins);
  REQUIRE(twins.candidates.size() == 2);
  CHECK(twins.candidates[0].verdict == Verdict::rivalled);
  REQUIRE(twins.candidates[0].rival);
  CHECK(twins.candidates[0].rival->id == twins.candidates[1].id);
  CHECK(twins.places == 2);
  CHECK(look_up(here));  // the same place twice is no rival
}

TEST_CASE("without poses ids far apart are rivals, neighbours and loops of one session are not",
          "[recognition]") {
  const SyntheticRoom room(6, 9, 5);
  const TopologyGraph<> seen = room.seen_from(here);
  const auto accepted = [&](std::uint64_t second, std::uint32_t session) {
    Relocalizer<> relocalizer;
    relocalizer.map().add(KeyframeId{1}, seen);
    EntryInfo info;
    info.session = session;
    relocalizer.map().add(KeyframeId{second}, seen, info);
    return static_cast<bool>(relocalizer.localize(seen));
  };
  CHECK(accepted(2, 0));
  CHECK_FALSE(accepted(1000, 0));
  CHECK_FALSE(accepted(2, 1));
}

TEST_CASE("a false match that one graph lets through is refused by its place",
          "[recognition][regression]") {
  // The query shows eight objects; one key frame of the map shows three that lie like three of
  // them, and another one that the other five are not there.
  const SyntheticRoom room(8, 8, 8);
  const PinholeCamera<> camera{525, 525, 320, 240, 640, 480};
  View<> view;
  view.camera = camera;
  const TopologyGraph<> all = room.seen_from(here);
  const TopologyGraph<> query(all.nodes(), {}, {view});
  const TopologyGraph<> three({all.nodes()[0], all.nodes()[1], all.nodes()[2]});
  const auto support = [&](const TopologyGraph<>& beside) {
    BagOfTopologyGraphs<> bag;
    bag.add(KeyframeId{1}, three, standing_at(here));
    bag.add(KeyframeId{2}, beside, standing_at(here, 1));
    const TopologyGraph<> place = place_graph(bag, KeyframeId{1}, three, query, here);
    return judge_pose(place, query, here)->support();
  };
  CHECK(support(TopologyGraph<>(three.nodes(), {}, {view})) < support(three));
  CHECK(support(TopologyGraph<>(all.nodes(), {}, {view})) > support(three));
}

TEST_CASE("an accepted pose is tightened by the objects of the place around it", "[recognition]") {
  std::mt19937 random(21);
  double alone = 0.0, by_place = 0.0, said_alone = 0.0, said_by_place = 0.0;
  int tightened = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const SyntheticRoom room(seed, 12, 12);
    const auto measured_from = [&](const Eigen::Isometry3d& camera) {
      std::normal_distribution<double> normal;
      const TopologyGraph<> exact = room.seen_from(camera);
      std::vector<SemanticNode<>> nodes = exact.nodes();
      for (SemanticNode<>& node : nodes) {
        const Eigen::Vector3d noise(normal(random), normal(random), normal(random));
        *node.position += node.covariance.llt().matrixL() * noise;
      }
      return TopologyGraph<>(std::move(nodes));
    };
    Relocalizer<> relocalizer;
    std::vector<Eigen::Isometry3d> cameras;
    for (std::uint64_t id = 0; id < 6; ++id) {
      cameras.push_back(random_camera(random));
      relocalizer.map().add(KeyframeId{id}, measured_from(cameras.back()),
                            standing_at(cameras.back()));
    }
    const Eigen::Isometry3d q = random_camera(random);
    const Recognition found = relocalizer.localize(measured_from(q));
    REQUIRE(found);
    const auto& report = *std::find_if(
        found.candidates.begin(), found.candidates.end(),
        [&](const CandidateReport& candidate) { return candidate.id == found.accepted->id; });
    if (!report.place_pose) continue;
    ++tightened;
    const Eigen::Isometry3d truth = cameras[value(report.id)].inverse() * q;
    const auto error = [&](const Eigen::Isometry3d& T) {
      return (T.translation() - truth.translation()).norm();
    };
    CHECK(found.accepted->pose->T_candidate_query.isApprox(report.place_pose->T_target_source));
    said_alone += report.pose->covariance.trace();
    said_by_place += found.accepted->pose->covariance.trace();
    alone += error(report.pose->T_candidate_query);
    by_place += error(found.accepted->pose->T_candidate_query);
  }
  CHECK(tightened >= 10);
  CHECK(by_place < 0.9 * alone);
  CHECK(said_by_place < 0.9 * said_alone);
}
