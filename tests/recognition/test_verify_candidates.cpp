// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/recognition/verify_candidates.hpp>

#include "catch.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

namespace {

const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();

std::vector<Candidate> all_of(const BagOfTopologyGraphs<>& bag, const TopologyGraph<>& query) {
  QueryOptions options;
  options.max_results = bag.size();
  return bag.query(query, options);
}

/// Three objects on a line and two more of other classes on it.
TopologyGraph<> line_graph() {
  std::vector<SemanticNode<>> nodes;
  for (int i = 0; i < 5; ++i) {
    SemanticNode<> node;
    node.label = ClassId{i};
    node.position = Eigen::Vector3d(0.5 * i * i, 0.0, 3.0);
    node.size = {0.2, 0.2};
    node.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    nodes.push_back(node);
  }
  return make_topology_graph(std::move(nodes), KnnEdges{});
}

}  // namespace

TEST_CASE("a query of two objects is not usable and gets no reports", "[recognition]") {
  const SyntheticRoom room(1, 8, 8);
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{1}, room.seen_from(origin));
  const TopologyGraph<> two = SyntheticRoom(1, 2, 8).seen_from(origin);
  const Recognition recognition = verify_candidates(bag, two, all_of(bag, two));
  CHECK_FALSE(recognition.usable);
  CHECK_FALSE(recognition);
  CHECK(recognition.candidates.empty());
}

TEST_CASE("of several good candidates the best is accepted and the rest are not the best",
          "[recognition]") {
  std::mt19937 random(3);
  const SyntheticRoom room(2, 9, 6);
  BagOfTopologyGraphs<> bag;
  for (std::uint64_t id = 0; id < 4; ++id) {
    bag.add(KeyframeId{id}, room.seen_from(random_camera(random)));
  }
  const TopologyGraph<> query = room.seen_from(random_camera(random));
  const Recognition recognition = verify_candidates(bag, query, all_of(bag, query));
  REQUIRE(recognition);
  REQUIRE(recognition.candidates.size() == 4);
  CHECK(std::is_sorted(recognition.candidates.begin(), recognition.candidates.end(),
                       [](const auto& a, const auto& b) { return a.margin() > b.margin(); }));
  CHECK(recognition.accepted->id == recognition.candidates.front().id);
  CHECK(recognition.candidates.front().verdict == Verdict::accepted);
  for (std::size_t i = 1; i < 4; ++i) {
    CHECK(recognition.candidates[i].verdict == Verdict::not_best);
  }
}

TEST_CASE("equal candidates go to the smaller id", "[recognition]") {
  const TopologyGraph<> graph = SyntheticRoom(5, 8, 8).seen_from(origin);
  BagOfTopologyGraphs<> bag;
  for (const std::uint64_t id : {9u, 4u, 6u}) bag.add(KeyframeId{id}, graph);
  const Recognition recognition = verify_candidates(
      bag, graph, {{KeyframeId{9}, 1.0}, {KeyframeId{6}, 1.0}, {KeyframeId{4}, 1.0}});
  REQUIRE(recognition);
  CHECK(recognition.accepted->id == KeyframeId{4});
  CHECK(recognition.candidates[1].id == KeyframeId{6});
}

TEST_CASE("a candidate that has left the bag is passed over", "[recognition]") {
  const TopologyGraph<> graph = SyntheticRoom(5, 8, 8).seen_from(origin);
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{4}, graph);
  const Recognition recognition =
      verify_candidates(bag, graph, {{KeyframeId{3}, 1.0}, {KeyframeId{4}, 0.5}});
  REQUIRE(recognition.candidates.size() == 1);
  CHECK(recognition.candidates[0].id == KeyframeId{4});
  CHECK(recognition.candidates[0].similarity == 0.5);
}

TEST_CASE("objects on one line leave the pose open", "[recognition]") {
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{0}, line_graph());
  const Recognition recognition = verify_candidates(bag, line_graph(), {{KeyframeId{0}, 1.0}});
  CHECK_FALSE(recognition);
  REQUIRE(recognition.candidates.size() == 1);
  CHECK(recognition.candidates[0].verdict == Verdict::degenerate);
}

TEST_CASE("no object of a common class, no agreement", "[recognition]") {
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{0}, line_graph());
  std::vector<SemanticNode<>> others = line_graph().nodes();
  for (SemanticNode<>& node : others) node.label = ClassId{value(node.label) + 50};
  const TopologyGraph<> query(std::move(others));
  const Recognition recognition = verify_candidates(bag, query, {{KeyframeId{0}, 0.0}});
  REQUIRE(recognition.candidates.size() == 1);
  CHECK(recognition.candidates[0].verdict == Verdict::no_agreement);
  CHECK_FALSE(recognition.candidates[0].pose);
}

TEST_CASE("a match below the asked score may be chance", "[recognition]") {
  const TopologyGraph<> graph = SyntheticRoom(5, 8, 8).seen_from(origin);
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{0}, graph);
  RecognitionOptions strict;
  strict.decision.min_score = 1e6;
  const Recognition recognition = verify_candidates(bag, graph, {{KeyframeId{0}, 1.0}}, strict);
  REQUIRE(recognition.candidates.size() == 1);
  CHECK(recognition.candidates[0].verdict == Verdict::insignificant);
  CHECK(recognition.candidates[0].threshold == 1e6);
  CHECK(recognition.candidates[0].margin() < 0.0);
}

TEST_CASE("the matched objects, counted by class, are the inliers", "[recognition]") {
  std::mt19937 random(11);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const SyntheticRoom room(seed, 9, 4);
    const TopologyGraph<> query = room.seen_from(random_camera(random));
    BagOfTopologyGraphs<> bag;
    bag.add(KeyframeId{0}, room.seen_from(random_camera(random)));
    bag.add(KeyframeId{1}, SyntheticRoom(seed + 100, 9, 4).seen_from(origin));
    for (const CandidateReport& report :
         verify_candidates(bag, query, all_of(bag, query)).candidates) {
      std::map<ClassId, std::size_t> counted;
      if (report.pose) {
        for (const Correspondence& pair : report.pose->inliers) {
          ++counted[query.node(pair.query).label];
        }
      }
      CHECK(report.matched == counted);
      CHECK((report.pose || report.verdict == Verdict::no_agreement));
    }
  }
}

namespace {

RelativePose pose_with(double score, bool degenerate, const Eigen::Isometry3d& T = origin) {
  RelativePose pose;
  pose.significance = score;
  pose.degenerate = degenerate;
  pose.T_candidate_query = T;
  pose.covariance = 1e-4 * Eigen::Matrix<double, 6, 6>::Identity();
  return pose;
}

/// The verdict on a candidate with these poses, best first, at a threshold of 1 and a lead of 1.
Verdict verdict_on(std::vector<RelativePose> poses) {
  DecisionOptions options;
  options.min_score = 1.0;
  detail::prefer_determined(poses, [&](const auto&) { return *options.min_score; });
  CandidateReport report;
  report.threshold = *options.min_score;
  report.pose = poses.front();
  report.other_poses.assign(poses.begin() + 1, poses.end());
  return detail::judge_candidate(report, TopologyGraph<>{}, options);
}

const Eigen::Isometry3d aside(Eigen::Translation3d(1, 0, 0));

}  // namespace

TEST_CASE("a good pose is not lost behind a degenerate one that leaves it open", "[recognition]") {
  // A line of objects along x fits best, turned about it by any angle; one of these is the pose
  // that more spread objects give.
  const Eigen::Isometry3d turned(Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitX()));
  RelativePose line = pose_with(3.0, true);
  line.covariance(3, 3) = 1.0;  // rad²
  CHECK(verdict_on({line, pose_with(2.0, false, turned)}) == Verdict::accepted);
  CHECK(verdict_on({line, pose_with(0.5, false, turned)}) == Verdict::degenerate);
  CHECK(verdict_on({line, pose_with(2.0, true, turned)}) == Verdict::degenerate);
  CHECK(verdict_on({line}) == Verdict::degenerate);
  // It is the candidate's axis, wherever the query's camera was.
  line.T_candidate_query = Eigen::Translation3d(0, 0, 5);
  const Eigen::Isometry3d T_candidate_query = turned * line.T_candidate_query;
  CHECK(verdict_on({line, pose_with(2.0, false, T_candidate_query)}) == Verdict::accepted);
}

TEST_CASE("a place alone is said only where its score is as much as is asked for",
          "[recognition][regression]") {
  CHECK(verdict_on({pose_with(1.0, true)}) == Verdict::degenerate);
  CHECK(verdict_on({pose_with(0.9, true)}) == Verdict::insignificant);
  CHECK(verdict_on({pose_with(0.9, false)}) == Verdict::insignificant);
}

TEST_CASE("a degenerate pose elsewhere that fits better makes a match ambiguous", "[recognition]") {
  CHECK(verdict_on({pose_with(3.0, true), pose_with(2.0, false, aside)}) == Verdict::ambiguous);
  // One that fits less does not, unlike one that is not degenerate.
  CHECK(verdict_on({pose_with(2.0, false, aside), pose_with(1.9, true)}) == Verdict::accepted);
  CHECK(verdict_on({pose_with(2.0, false, aside), pose_with(1.9, false)}) == Verdict::ambiguous);
  CHECK(verdict_on({pose_with(3.5, false, aside), pose_with(2.4, false)}) == Verdict::accepted);
}

TEST_CASE("a bag that does not count its places is as large as its candidates are many",
          "[recognition]") {
  /// What `verify_candidates` needs of a bag.
  struct PlainBag {
    using Graph = TopologyGraph<>;
    const BagOfTopologyGraphs<>* bag;
    std::vector<Candidate> query(const Graph& graph, const QueryOptions& options) const {
      return bag->query(graph, options);
    }
    std::optional<Graph> find(KeyframeId id) const { return bag->find(id); }
    std::optional<EntryInfo> info(KeyframeId id) const { return bag->info(id); }
  };
  std::mt19937 random(21);
  BagOfTopologyGraphs<> bag;
  for (unsigned i = 0; i < 60; ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    bag.add(KeyframeId{i}, SyntheticRoom(i, 6, 6).seen_from(T_room_camera),
            standing_at(Eigen::Translation3d(20.0 * i, 0.0, 0.0) * T_room_camera));
  }
  const TopologyGraph<> query = SyntheticRoom(3, 6, 6).seen_from(random_camera(random));
  for (const std::size_t candidates : {5U, 20U}) {
    QueryOptions options;
    options.max_results = candidates;
    const auto retrieved = bag.query(query, options);
    const Recognition told = verify_candidates(bag, query, retrieved);
    const Recognition untold = verify_candidates(PlainBag{&bag}, query, retrieved);
    CHECK(told.places == bag.places());
    CHECK(untold.places == candidates);
    for (const CandidateReport& report : untold.candidates) {
      CHECK(report.places == candidates);  // any of them may hold what was matched
      CHECK(report.threshold == DecisionOptions{}.threshold(candidates, false));
    }
  }
}
