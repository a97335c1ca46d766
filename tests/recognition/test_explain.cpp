// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"
#include "random_appearance.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

namespace {

const ExplainedStage& stage(const CandidateExplanation& candidate, const std::string& name) {
  const auto found = std::find_if(candidate.stages.begin(), candidate.stages.end(),
                                  [&](const ExplainedStage& s) { return s.name == name; });
  REQUIRE(found != candidate.stages.end());
  return *found;
}

}  // namespace

TEST_CASE("every candidate's stages tell its verdict", "[recognition]") {
  std::mt19937 random(1);
  std::size_t accepted = 0, not_best = 0, refused = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    Relocalizer<> relocalizer;
    for (unsigned i = 0; i < 6; ++i) {  // the query's room twice, and others
      relocalizer.map().add(
          KeyframeId{i},
          SyntheticRoom(seed + i / 2, 3 + seed % 6, 3).seen_from(random_camera(random)));
    }
    const auto query = SyntheticRoom(seed, 3 + seed % 6, 3).seen_from(random_camera(random));
    const Recognition found = relocalizer.localize(query);
    const Explanation explanation =
        explain(found, relocalizer.map(), query, ClassCatalog::coco80(), relocalizer.options());
    CHECK(explanation.objects == query.size());
    CHECK(explanation.usable);
    REQUIRE(explanation.candidates.size() == found.candidates.size());
    for (std::size_t i = 0; i < found.candidates.size(); ++i) {
      const CandidateReport& report = found.candidates[i];
      const CandidateExplanation& candidate = explanation.candidates[i];
      CAPTURE(seed, to_string(candidate));
      CHECK(candidate.id == report.id);
      CHECK(candidate.verdict == report.verdict);
      CHECK((candidate.failed() == nullptr) == (report.verdict == Verdict::accepted));
      CHECK(candidate.matched.size() == (report.pose ? report.pose->inliers.size() : 0));
      for (const ExplainedStage& s : candidate.stages) {
        if (s.missed_by() > 0.0) CHECK_FALSE(s.passed);
      }
      for (const ExplainedMatch& match : candidate.matched) CHECK(match.deviations <= 3.0);
      switch (report.verdict) {
        case Verdict::accepted:
          ++accepted;
          break;
        case Verdict::not_best:
          ++not_best;
          CHECK(candidate.failed()->name == (report.place_support
                                                 ? "lead over the threshold, beside the best one's"
                                                 : "first of its place, which is judged for all"));
          break;
        case Verdict::no_agreement:
          CHECK(candidate.failed()->name == "objects that agree");
          ++refused;
          break;
        case Verdict::insignificant:
          CHECK(candidate.failed()->name == "score");
          CHECK(candidate.failed()->missed_by() == Approx(-report.margin()));
          ++refused;
          break;
        case Verdict::ambiguous:
          CHECK(candidate.failed()->name.find(" pose") != std::string::npos);
          ++refused;
          break;
        case Verdict::rivalled:
          CHECK(candidate.failed()->name == "support over another place");
          ++refused;
          break;
        case Verdict::degenerate:
          CHECK((candidate.failed()->name == "spread off a line" ||
                 candidate.failed()->name == "deviation of the rotation"));
          ++refused;
          break;
      }
    }
  }
  CHECK(accepted > 0);
  CHECK(not_best > 0);
  CHECK(refused > 0);
}

TEST_CASE("what was expected and is missing is named, with its place and why", "[recognition]") {
  const ClassCatalog coco = ClassCatalog::coco80();
  std::vector<SemanticNode<>> nodes{object_at(value(coco.at("tv")), {-0.6, 0, 3}),
                                    object_at(value(coco.at("cup")), {0.5, 0.2, 2.5}),
                                    object_at(value(coco.at("vase")), {0, -0.6, 2.8}),
                                    object_at(value(coco.at("book")), {0.1, 0.5, 3.2}),
                                    object_at(999, {-0.2, 0.3, 2.4})};
  const TopologyGraph<> query(nodes, {}, {[] {
                                View<> view;
                                view.camera = {500.0, 500.0, 319.5, 239.5, 640, 480};
                                return view;
                              }()});
  nodes.push_back(object_at(value(coco.at("keyboard")), {0.4, -0.3, 3}));
  Relocalizer<> relocalizer;
  relocalizer.map().add(KeyframeId{3}, TopologyGraph<>(nodes));
  const Recognition found = relocalizer.localize(query);
  REQUIRE(found);
  const Explanation explanation = explain(found, relocalizer.map(), query, coco, {});
  REQUIRE(explanation.candidates.size() == 1);
  const CandidateExplanation& candidate = explanation.candidates[0];
  REQUIRE(candidate.missing.size() == 1);
  CHECK(candidate.missing[0].class_name == "keyboard");
  CHECK(candidate.missing[0].of_candidate);
  CHECK(candidate.missing[0].position == *nodes.back().position);
  CHECK(candidate.missing[0].measured_views == 0);
  REQUIRE(candidate.changes.size() == 1);
  CHECK(candidate.changes[0].class_name == "keyboard");
  CHECK(candidate.changes[0].change.kind == ChangeKind::gone);
  CHECK(stage(candidate, "score").value == found.accepted->score());
  CHECK(to_string(explanation).find("matched class 999") != std::string::npos);
}

TEST_CASE("what the query holds and the candidate lacks is placed in the candidate's frame",
          "[recognition]") {
  std::mt19937 random(5);
  const TopologyGraph<> place = noisy_graph(random, 6, 6, 0.01);
  View<> view;
  view.camera = {300.0, 300.0, 319.5, 239.5, 640, 480};
  const TopologyGraph<> candidate(place.nodes(), {}, {view});
  Eigen::Isometry3d T_candidate_query = Eigen::Isometry3d::Identity();
  T_candidate_query.translation() = Eigen::Vector3d(0.4, -0.1, 0.2);
  auto nodes = moved(place, T_candidate_query.inverse()).nodes();
  nodes.push_back(object_at(9, {-0.2, 0.3, 2.5}));
  const TopologyGraph<> query(nodes);
  Relocalizer<> relocalizer;
  relocalizer.map().add(KeyframeId{3}, candidate);
  const Recognition found = relocalizer.localize(query);
  REQUIRE(found);
  const ClassCatalog coco = ClassCatalog::coco80();
  const Explanation explanation = explain(found, relocalizer.map(), query, coco, {});
  REQUIRE(explanation.candidates.at(0).missing.size() == 1);
  const ExplainedMissing& missing = explanation.candidates[0].missing[0];
  CHECK_FALSE(missing.of_candidate);
  CHECK((missing.position - T_candidate_query * Eigen::Vector3d(-0.2, 0.3, 2.5)).norm() < 0.01);

  // The report names the query's seventh node; a query without it is another.
  const TopologyGraph<> other_query(std::vector<SemanticNode<>>(nodes.begin(), nodes.end() - 1));
  CHECK(explain(found, relocalizer.map(), other_query, coco, {}).candidates.empty());
}

TEST_CASE("the support of a pose is told beside that of the best other one", "[recognition]") {
  CandidateReport report;
  report.pose.emplace();
  report.pose->significance = 9.0;
  report.pose->degenerate = false;
  for (const double support : {2.0, 5.0, 3.0}) {
    RelativePose& other = report.other_poses.emplace_back();
    other.significance = support;
    other.degenerate = false;
  }
  const auto stages = detail::stages_of(report, TopologyGraph<>{}, TopologyGraph<>{},
                                        RecognitionOptions{}, std::nullopt);
  CHECK(stages.back().name == "support over other poses");
  CHECK(stages.back().value == Approx(4.0));
}

TEST_CASE("a candidate that has left the bag is passed over, an unusable query is said to be",
          "[recognition]") {
  Relocalizer<> relocalizer;
  const auto graph = SyntheticRoom(1, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  relocalizer.map().add(KeyframeId{1}, graph);
  const Recognition found = relocalizer.localize(graph);
  relocalizer.map().erase(KeyframeId{1});
  const ClassCatalog coco = ClassCatalog::coco80();
  CHECK(explain(found, relocalizer.map(), graph, coco, {}).candidates.empty());
  CHECK_FALSE(explain(Recognition{}, relocalizer.map(), TopologyGraph<>{}, coco, {}).usable);
}

TEST_CASE("a candidate that has become another is passed over", "[recognition][regression]") {
  Relocalizer<> relocalizer;
  const auto graph = SyntheticRoom(1, 8, 8).seen_from(Eigen::Isometry3d::Identity());
  relocalizer.map().add(KeyframeId{1}, graph);
  const Recognition found = relocalizer.localize(graph);
  REQUIRE(found);
  relocalizer.map().update(KeyframeId{1}, TopologyGraph<>({graph.nodes()[0]}));
  const ClassCatalog coco = ClassCatalog::coco80();
  CHECK(explain(found, relocalizer.map(), graph, coco, {}).candidates.empty());
}

TEST_CASE("a search that was cut short is told", "[recognition][regression]") {
  std::vector<SemanticNode<>> chairs;
  std::mt19937 random(3);
  for (int i = 0; i < 23; ++i) {  // 529 pairs, more than are offered
    chairs.push_back(object_at(56, random_motion(random, 2.0).translation()));
  }
  const TopologyGraph<> room(std::move(chairs));
  Relocalizer<> relocalizer;
  relocalizer.map().add(KeyframeId{1}, room);
  const Recognition found = relocalizer.localize(room);
  const Explanation explanation =
      explain(found, relocalizer.map(), room, ClassCatalog::coco80(), relocalizer.options());
  REQUIRE(explanation.candidates.size() == 1);
  CHECK_FALSE(explanation.candidates[0].complete);
  CHECK(to_string(explanation).find("cut short") != std::string::npos);
}

TEST_CASE("an explanation says what the matched objects' looks are worth",
          "[recognition][appearance]") {
  std::mt19937 random(3);
  const TopologyGraph<> plain = noisy_graph(random, 8, 4);
  const TopologyGraph<> candidate = with_appearance(random, plain, ColorDescriptor::kind);
  const TopologyGraph<> query = with_appearance(random, plain, ColorDescriptor::kind);
  const RecognitionOptions options;
  CandidateReport report;
  report.pose = match_graphs(candidate, query, options.matching).poses.at(0);
  const CandidateExplanation explanation =
      explain_candidate(report, candidate, query, ClassCatalog::coco80(), options);
  REQUIRE(explanation.matched.size() >= 6);
  std::size_t compared = 0;
  for (const ExplainedMatch& match : explanation.matched) {
    const Appearance& there = candidate.node(match.candidate).appearance;
    const Appearance& here = query.node(match.query).appearance;
    CHECK(match.looks.has_value() == (there.known() && here.known()));
    if (!match.looks) continue;
    CHECK(*match.looks == options.matching.chance.appearance.log10_odds(there, here));
    ++compared;
  }
  CHECK(compared > 0);
}

TEST_CASE("an explanation tells of so many candidates, the accepted one among them",
          "[recognition]") {
  std::mt19937 random(31);
  const SyntheticRoom room(4, 8, 6);
  Relocalizer<> relocalizer;
  for (std::uint64_t id = 0; id < 30; ++id) {
    const Eigen::Isometry3d camera = random_camera(random);
    relocalizer.map().add(KeyframeId{id}, room.seen_from(camera), standing_at(camera));
  }
  const auto query = room.seen_from(random_camera(random));
  const Recognition found = relocalizer.localize(query);
  REQUIRE(found);
  const auto told = [&](std::size_t most) {
    return explain(found, relocalizer.map(), query, ClassCatalog::coco80(), relocalizer.options(),
                   most)
        .candidates;
  };
  CHECK(told(0).empty());
  CHECK(told(1000).size() == found.candidates.size());
  const auto few = told(4);
  REQUIRE(few.size() == 4);
  CHECK(std::any_of(few.begin(), few.end(), [&](const CandidateExplanation& candidate) {
    return candidate.id == found.accepted->id;
  }));
}
