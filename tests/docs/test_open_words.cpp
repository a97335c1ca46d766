// SPDX-License-Identifier: MIT
// Classes of one's own and open words of examples/docs/choosing.md.
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include <topobag/graph/local_graph.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/sensing/lift_detections.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const AppearanceKind words("CLIP text, 64 of a PCA", 64);
constexpr ClassId mug{0}, cup{1}, thing{2};

/// What a detector of open words says of an object.
struct Worded {
  BoundingBox box;
  double metres = 0.0;
  ClassId label{};
  std::vector<WeightedLabel> scores;
  Eigen::VectorXd embedding;
};

}  // namespace

template <>
struct topobag::detection_traits<Worded> {
  static BoundingBox box(const Worded& d) { return d.box; }
  static ClassId label(const Worded& d) { return d.label; }
  static double confidence(const Worded&) { return 0.9; }
  static std::optional<double> depth(const Worded& d) { return d.metres; }
  static LabelWeights label_weights(const Worded& d) { return LabelWeights(d.scores); }
  static Appearance appearance(const Worded& d) { return {words, d.embedding}; }
};
static_assert(is_weighted_detection_v<Worded> && is_described_detection_v<Worded>);

namespace {

ClassCatalog own_catalog() {
  ClassCatalog catalog;
  catalog.add(mug, "mug", Dynamics::low);
  catalog.add(cup, "cup", Dynamics::low);
  catalog.add(thing, "thing", Dynamics::low);
  return catalog;
}

/// Nine things of a desk whose words are drawn anew for each seed.
std::vector<Worded> seen_things(unsigned seed, double noise) {
  std::mt19937 random(7), drawn(seed), other(seed + 100);
  std::uniform_real_distribution<double> along(40.0, 560.0), depth(1.0, 2.5);
  std::normal_distribution<double> normal;
  std::vector<Worded> things(9);
  for (Worded& d : things) {
    const double u = along(random), v = 0.7 * along(random);
    d.box = {u, v, u + 40.0, v + 30.0};
    d.metres = depth(random);
    d.label = thing;
    d.embedding = Eigen::VectorXd::NullaryExpr(64, [&] { return normal(drawn); });
    d.embedding += noise * Eigen::VectorXd::NullaryExpr(64, [&] { return normal(other); });
  }
  return things;
}

TopologyGraph<> graph_of_things(const std::vector<Worded>& things) {
  const PinholeCamera<> camera{500.0, 500.0, 320.0, 240.0, 640, 480};
  return TopologyGraph<>(lift_detections(things, camera, own_catalog()).nodes);
}

}  // namespace

TEST_CASE("a page's affinity lets the map's mugs be called cups, not the other way", "[docs]") {
  RecognitionOptions options;
  const ClassAffinity affinity = [](ClassId candidate, ClassId query) {
    return candidate == mug && query == cup ? 0.5 : 0.0;  // the map's mugs may be called cups
  };
  options.matching.consistency.affinity = affinity;  // which pairs are offered
  options.matching.chance.affinity = affinity;       // what they cost
  std::vector<Worded> things = seen_things(1, 0.0);
  const auto called = [&](ClassId label) {
    things[4].label = label;
    return graph_of_things(things);
  };
  const auto inliers = [&](ClassId candidate, ClassId query) {
    Relocalizer<> relocalizer(options);
    relocalizer.map().add(KeyframeId{1}, called(candidate));
    return relocalizer.localize(called(query)).candidates.front().pose->inliers.size();
  };
  CHECK(inliers(mug, cup) == 9);
  CHECK(inliers(mug, mug) == 9);
  CHECK(inliers(cup, mug) == 8);
}

TEST_CASE("a page's label weights go with the object into the map", "[docs]") {
  std::vector<Worded> things = seen_things(1, 0.0);
  things[4].label = cup;
  things[4].scores = {{cup, 0.5}, {mug, 0.4}};
  const TopologyGraph<> wavering = graph_of_things(things);
  CHECK(wavering.nodes()[4].label_weights == LabelWeights(things[4].scores));
  things[4].label = mug;
  things[4].scores = {{mug, 0.55}, {cup, 0.45}};
  CHECK(match_graphs(wavering, graph_of_things(things)).poses.front().inliers.size() == 9);
  things[4].scores = {{mug, 1.0}};
  CHECK(match_graphs(wavering, graph_of_things(things)).poses.front().inliers.size() == 9);
  things[4].scores = {{cup, 0.55}, {mug, 0.45}};
  CHECK_THROWS_AS(graph_of_things(things), InvalidValue);  // the best is not the label
  things[4].scores = {{mug, 0.55}, {ClassId{9}, 0.45}};
  CHECK_THROWS_AS(graph_of_things(things), UnknownClass);
}

TEST_CASE("a page's words tell one layout of things from another", "[docs]") {
  RecognitionOptions options;
  AppearanceModel& looks = options.matching.chance.appearance;
  looks.kind = words;
  looks.table = {{0.5, -1.0}, {0.8, 0.0}, {0.95, 0.7}};  // cosine, log10 odds of one object
  const TopologyGraph<> map = graph_of_things(seen_things(1, 0.0));
  const auto score = [&](const TopologyGraph<>& query, const MatchOptions& matching) {
    return match_graphs(map, query, matching).poses.front().score();
  };
  const TopologyGraph<> same = graph_of_things(seen_things(1, 0.2));
  const TopologyGraph<> others = graph_of_things(seen_things(2, 0.2));
  CHECK(score(same, options.matching) > score(same, MatchOptions()) + 1.0);
  CHECK(score(others, options.matching) < score(others, MatchOptions()) - 1.0);
}
