// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include <topobag/matching/chance_model.hpp>
#include <topobag/matching/class_confusion.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

const ClassId tv{1}, laptop{2}, book{3};

}  // namespace

TEST_CASE("without counts a confusion is its prior", "[matching]") {
  const ClassConfusion confusion({6.0, 2.0, 5});
  CHECK(confusion.probability(tv, tv) == Approx(0.75));
  CHECK(confusion.probability(tv, laptop) == Approx(0.25 / 4));
  CHECK(confusion.cost(tv, laptop) == Approx(-std::log10(0.0625)));
}

TEST_CASE("counts and prior add up to the probabilities of a row", "[matching]") {
  ClassConfusion confusion({6.0, 2.0, 5});
  confusion.add(tv, tv, 22.0);
  for (int i = 0; i < 10; ++i) confusion.add(tv, laptop);
  CHECK(confusion.probability(tv, tv) == Approx(28.0 / 40.0));
  CHECK(confusion.probability(tv, laptop) == Approx(10.5 / 40.0));
  CHECK(confusion.probability(laptop, tv) == Approx(0.0625));  // rows are the map's classes
  double sum = 0.0;
  for (int label = 1; label <= 5; ++label) sum += confusion.probability(tv, ClassId{label});
  CHECK(sum == Approx(1.0));
}

TEST_CASE("a given matrix is reached with its weight", "[matching]") {
  ClassConfusion confusion;
  confusion.add(tv, tv, 0.7e6);
  confusion.add(tv, laptop, 0.3e6);
  CHECK(confusion.probability(tv, laptop) == Approx(0.3).epsilon(1e-4));
}

TEST_CASE("classes that are often confused are grouped", "[matching]") {
  ClassConfusion confusion;
  confusion.add(tv, tv, 100.0);
  confusion.add(tv, laptop, 20.0);
  confusion.add(book, book, 1000.0);
  confusion.add(book, laptop, 1.0);
  const ClassGroups groups = confusion.groups(0.05);
  CHECK(groups.compatible(tv, laptop));
  CHECK_FALSE(groups.compatible(book, laptop));
  ClassGroups base;
  base.join(book, ClassId{9});
  CHECK(confusion.groups(0.05, base).compatible(book, ClassId{9}));
  CHECK(confusion.groups(1.0).group(laptop) == laptop);
}

TEST_CASE("counts must be numbers", "[matching]") {
  ClassConfusion confusion;
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(confusion.add(tv, tv, bad), InvalidValue);
    CHECK_THROWS_AS(ClassConfusion({bad, 1.0, 5}), InvalidValue);
  }
  CHECK_THROWS_AS(ClassConfusion({1.0, 1.0, 1}), InvalidValue);
  CHECK(confusion.probability(tv, tv) == ClassConfusion().probability(tv, tv));
}

TEST_CASE("a pair of two classes costs what the confusion says, others what they did",
          "[matching]") {
  const auto graph_of = [](int last) {
    return TopologyGraph<>({object_at(10, {0, 0, 3}), object_at(11, {1, 0, 3}),
                            object_at(12, {0, 1, 4}), object_at(last, {1, 1, 3.5})});
  };
  const TopologyGraph<> candidate = graph_of(value(tv)), query = graph_of(value(laptop));
  std::vector<Correspondence> pairs;
  std::vector<PointPair> points;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& node = candidate.nodes()[i];
    pairs.push_back({node_index(i), node_index(i)});
    points.push_back({*node.position, *node.position, node.covariance, node.covariance});
  }
  const RefinedPose pose = refine_pose(Eigen::Isometry3d::Identity(), points);
  ClassGroups groups;
  groups.join(tv, laptop);
  const auto significance = [&](const ChanceModel& model, const TopologyGraph<>& of) {
    return model.significance(candidate, of, pairs, points, pose, groups);
  };
  ChanceModel with_confusion;
  with_confusion.confusion.emplace().add(tv, laptop, 5.0);
  CHECK(significance(with_confusion, candidate) == significance({}, candidate));
  CHECK(significance({}, query) - significance(with_confusion, query) ==
        Approx(with_confusion.confusion->cost(tv, laptop) - ChanceModel{}.relabeling));
}
