// SPDX-License-Identifier: MIT
// Where both graphs know which way is down two objects determine a pose, and decide nothing.
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/recognition/why.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// An object of each class, at a place of its own.
TopologyGraph<> one_of_each(const std::vector<int>& classes, bool gravity) {
  const std::array<Eigen::Vector3d, 4> places{
      {{-1.0, 0.2, 3.0}, {0.8, -0.1, 4.0}, {0.1, 0.9, 3.5}, {1.2, 0.6, 2.6}}};
  std::vector<SemanticNode<>> nodes;
  for (const int label : classes) {
    SemanticNode<> node;
    node.label = ClassId{label};
    node.position = places[static_cast<std::size_t>(label)];
    node.size = {0.3, 0.2};
    node.covariance = 4e-4 * Eigen::Matrix3d::Identity();
    nodes.push_back(node);
  }
  std::optional<Gravity<>> down;
  if (gravity) down = Gravity<>{Eigen::Vector3d::UnitY(), 0.01};
  return TopologyGraph<>(std::move(nodes), {}, {}, down);
}

}  // namespace

TEST_CASE("explain asks for as many objects as determine a pose", "[recognition][regression]") {
  for (const bool gravity : {false, true}) {
    Relocalizer<> relocalizer;
    relocalizer.map().add(KeyframeId{1}, one_of_each({0, 1, 2}, gravity));
    const TopologyGraph<> query = one_of_each({0, 1, 3}, gravity);
    const Recognition found = relocalizer.localize(query);
    CHECK_FALSE(found);  // two of the three agree
    const Explanation told =
        explain(found, relocalizer.map(), query, ClassCatalog::coco80(), relocalizer.options());
    REQUIRE(told.candidates.size() == 1);
    const ExplainedStage& agreeing = told.candidates[0].stages.front();
    CHECK(agreeing.name == "objects that agree");
    CHECK(agreeing.value == (gravity ? 2.0 : 0.0));
    CHECK(agreeing.asked == (gravity ? 2.0 : 3.0));
    CHECK(agreeing.passed == gravity);
    CHECK(agreeing.passed == (agreeing.missed_by() <= 0.0));
    CHECK(found.candidates[0].pose.has_value() == gravity);
    if (gravity) CHECK(found.candidates[0].score() < found.candidates[0].threshold);
  }
}

TEST_CASE("a vertical that one graph alone knows determines no pose of two", "[recognition]") {
  const TopologyGraph<> level = one_of_each({0, 1, 2}, true), other = one_of_each({0, 1, 3}, false);
  CHECK(match_graphs(level, one_of_each({0, 1, 3}, true)).poses.size() == 1);
  CHECK(match_graphs(level, other).poses.empty());
  CHECK(match_graphs(other, level).poses.empty());
}

TEST_CASE("a query of two objects is not asked, though they determine a pose", "[recognition]") {
  Relocalizer<> relocalizer;
  relocalizer.map().add(KeyframeId{1}, one_of_each({0, 1, 2}, true));
  const TopologyGraph<> query = one_of_each({0, 1}, true);
  CHECK_FALSE(query.is_matchable());
  const Recognition found = relocalizer.localize(query);
  CHECK_FALSE(found.usable);
  CHECK(found.candidates.empty());
  CHECK(why(found) == "not recognised: a query takes three objects with a position");
  CHECK(match_graphs(one_of_each({0, 1, 2}, true), query).poses.size() == 1);
}
