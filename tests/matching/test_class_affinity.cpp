// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <topobag/matching/class_affinity.hpp>
#include <topobag/matching/judge_pose.hpp>
#include <topobag/matching/match_graphs.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "matching/layouts.hpp"
#include "random_label_weights.hpp"

using namespace topobag;

namespace {

constexpr ClassId mug{1}, cup{2}, bowl{3}, lamp{4};

/// A mug may be a cup and a cup a bowl, and a mug no bowl; a bowl is hardly ever called a cup.
double of_crockery(ClassId candidate, ClassId query) {
  const auto is = [&](ClassId a, ClassId b) { return candidate == a && query == b; };
  if (is(mug, cup) || is(cup, mug)) return 0.5;
  if (is(cup, bowl)) return 0.25;
  if (is(bowl, cup)) return 0.01;
  return 0.0;
}

SemanticNode<> of_class(ClassId label, LabelWeights weights = {}) {
  SemanticNode<> node = object_at(value(label), {0, 0, 2});
  node.label_weights = weights;
  return node;
}

/// Seven objects of known places, of these classes.
TopologyGraph<> laid(const std::vector<ClassId>& labels, double turn = 0.0) {
  std::mt19937 random(4);
  const TopologyGraph<> graph = noisy_graph(random, labels.size(), 1, 0.02);
  auto nodes = graph.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].label = labels[i];
  const Eigen::Isometry3d T(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()));
  return moved(TopologyGraph<>(nodes), T);
}

MatchOptions with_crockery() {
  MatchOptions options;
  options.consistency.affinity = of_crockery;
  options.chance.affinity = of_crockery;
  return options;
}

}  // namespace

TEST_CASE("the affinity of two nodes is that of all that they may be", "[matching]") {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const auto drawn = [&] {
      const ClassId label{1 + static_cast<int>(random() % 3)};
      return of_class(label,
                      random() % 3 ? random_label_weights(random, label, 3) : LabelWeights());
    };
    const SemanticNode<> a = drawn(), b = drawn();
    const auto dense = [](const SemanticNode<>& node) {
      std::vector<double> weights(10, 0.0);
      if (node.label_weights.empty()) weights[static_cast<std::size_t>(value(node.label))] = 1.0;
      for (std::size_t i = 0; i < node.label_weights.size(); ++i) {
        weights[static_cast<std::size_t>(value(node.label_weights.label(i)))] =
            node.label_weights.byte(i) / 255.0;
      }
      return weights;
    };
    const auto product = [&](const SemanticNode<>& p, const SemanticNode<>& q) {
      double sum = 0.0;
      for (std::size_t i = 0; i < 10; ++i) {
        for (std::size_t k = 0; k < 10; ++k) {
          const double alike =
              i == k ? 1.0
                     : of_crockery(ClassId{static_cast<int>(i)}, ClassId{static_cast<int>(k)});
          sum += dense(p)[i] * dense(q)[k] * alike;
        }
      }
      return sum;
    };
    const double expected = std::min(1.0, product(a, b) / std::sqrt(product(a, a) * product(b, b)));
    CHECK(label_affinity(a, b, of_crockery) == Approx(expected));
    CHECK(label_affinity(a, a, of_crockery) == Approx(1.0));
    CHECK(label_affinity(a, b) == Approx(label_affinity(b, a)));  // without a say of the user's
  }
  CHECK(label_affinity(of_class(cup), of_class(bowl), of_crockery) == 0.25);
  CHECK(label_affinity(of_class(bowl), of_class(cup), of_crockery) == 0.01);
  CHECK(label_affinity(of_class(cup), of_class(bowl)) == 0.0);
}

TEST_CASE("an affinity that is not transitive decides which pairs are offered", "[matching]") {
  std::mt19937 random(5);
  ConsistencyOptions options;
  options.affinity = of_crockery;
  options.classes.join(mug, lamp);  // which an affinity passes over
  for (int trial = 0; trial < 100; ++trial) {
    const auto drawn = [&] {
      const TopologyGraph<> graph = noisy_graph(random, 1 + random() % 9, 4);
      auto nodes = graph.nodes();
      for (auto& node : nodes) node.label = ClassId{1 + static_cast<int>(random() % 4)};
      return random() % 2 ? TopologyGraph<>(nodes)
                          : with_label_weights(random, TopologyGraph<>(nodes));
    };
    const TopologyGraph<> candidate = drawn(), query = drawn();
    std::vector<Correspondence> expected;
    for (std::size_t q = 0; q < query.size(); ++q) {
      for (std::size_t p = 0; p < candidate.size(); ++p) {
        const auto &there = candidate.nodes()[p], &here = query.nodes()[q];
        if (detail::size_ratio(there, here) > options.max_size_ratio) continue;
        if (label_affinity(there, here, of_crockery) < options.min_affinity) continue;
        expected.push_back({node_index(p), node_index(q)});
      }
    }
    CHECK(detail::offered_pairs(candidate, query, options) == expected);
  }
  options.affinity = {};
  CHECK(detail::offered_pairs(laid({mug, cup}), laid({lamp, bowl}), options) ==
        std::vector<Correspondence>{{node_index(0), node_index(0)}});
}

TEST_CASE("a pair of two classes costs what their affinity says", "[matching]") {
  const std::vector<ClassId> map{cup, bowl, mug, lamp, lamp, mug, bowl};
  const TopologyGraph<> candidate = laid(map);
  const auto best = [&](const std::vector<ClassId>& query, const MatchOptions& options) {
    const GraphMatch match = match_graphs(candidate, laid(query, 0.7), options);
    REQUIRE_FALSE(match.poses.empty());
    return match.poses.front();
  };
  const MatchOptions options = with_crockery();
  const RelativePose same = best(map, options);
  CHECK(same.inliers.size() == 7);
  std::vector<ClassId> renamed = map;
  renamed[0] = mug;  // the cup
  const RelativePose with_mug = best(renamed, options);
  CHECK(with_mug.inliers.size() == 7);
  // The price of the label, and of the choice among cups and mugs.
  CHECK(with_mug.significance < same.significance - std::log10(2.0) + 1e-9);
  CHECK(best(renamed, MatchOptions()).inliers.size() == 6);
  renamed = map;
  renamed[2] = bowl;  // a mug is none
  CHECK(best(renamed, options).inliers.size() == 6);
  renamed = map;
  renamed[1] = cup;  // a bowl is hardly ever called a cup: below what is offered
  CHECK(best(renamed, options).inliers.size() == 6);
  MatchOptions careless = options;
  careless.consistency.min_affinity = 0.0;
  const RelativePose dear = best(renamed, careless);
  CHECK(dear.inliers.size() == 7);
  CHECK(dear.significance < same.significance - 2.0 + 1e-9);
  // Judged at its pose it is the same match.
  const auto judged = judge_pose(candidate, laid(renamed, 0.7), dear.T_candidate_query, careless);
  REQUIRE(judged);
  CHECK(judged->significance == Approx(dear.significance));
}

TEST_CASE("what is as uncertain in both costs nothing, and what was a look-alike is none dearer",
          "[matching]") {
  const LabelWeights unsure({{cup, 0.6}, {bowl, 0.4}}), other({{bowl, 0.7}, {cup, 0.3}});
  const ClassGroups apart;
  ClassGroups together;
  together.join(cup, bowl);
  const auto cost = [](const SemanticNode<>& p, const SemanticNode<>& q, const ClassGroups& groups,
                       const ClassAffinity& affinity = {}) {
    return label_cost(p, q, groups, affinity, 0.45);
  };
  CHECK(cost(of_class(cup, unsure), of_class(cup, unsure), apart) == Approx(0.0).margin(1e-12));
  const double common = cost(of_class(cup, unsure), of_class(bowl, other), apart);
  CHECK(common > 0.0);
  CHECK(common < 0.2);
  CHECK(cost(of_class(cup, unsure), of_class(bowl, other), together) == common);
  CHECK(cost(of_class(cup), of_class(bowl), together) == 0.45);
  CHECK(cost(of_class(cup), of_class(bowl), together, of_crockery) == Approx(std::log10(4.0)));
  CHECK(std::isinf(cost(of_class(cup), of_class(bowl), apart)));
  CHECK_FALSE(may_be_one(of_class(cup), of_class(bowl), apart, {}, 0.0));
  CHECK(may_be_one(of_class(cup, unsure), of_class(bowl), apart, {}, 0.5));
  CHECK_FALSE(may_be_one(of_class(cup, unsure), of_class(bowl), apart, {}, 0.6));
}

TEST_CASE("labels that a detector wavers between are matched across two detectors' answers",
          "[matching]") {
  const std::vector<ClassId> map{cup, bowl, mug, lamp, lamp, mug, bowl};
  std::vector<ClassId> seen = map;
  seen[0] = bowl;
  const auto wavering = [&](const TopologyGraph<>& graph) {
    auto nodes = graph.nodes();
    nodes[0].label_weights = LabelWeights({{nodes[0].label, 0.55}, {cup, 0.5}, {bowl, 0.5}});
    return TopologyGraph<>(nodes);
  };
  const TopologyGraph<> candidate = laid(map), query = laid(seen, 0.4);
  CHECK(match_graphs(candidate, query).poses.front().inliers.size() == 6);
  const RelativePose found = match_graphs(wavering(candidate), wavering(query)).poses.front();
  CHECK(found.inliers.size() == 7);
  CHECK(std::isfinite(found.significance));
}

TEST_CASE("an affinity that is none is refused by its classes", "[matching]") {
  const auto refused = [](double said) {
    return error_text([&] {
      label_affinity(of_class(cup), of_class(bowl), [=](ClassId, ClassId) { return said; });
    });
  };
  CHECK(refused(1.5).find("the affinity of the classes 2 and 3 is 1.5") == 0);
  CHECK(refused(-0.1).find("which is not in [0, 1]") != std::string::npos);
  CHECK(refused(std::nan("")).find("which is not in [0, 1]") != std::string::npos);
  CHECK(refused(1.0) == "nothing was thrown");
}
