// SPDX-License-Identifier: MIT
#include <set>
#include <string>
#include <vector>

#include <topobag/matching/missing_objects.hpp>
#include <topobag/recognition/changes.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

const Eigen::Isometry3d T_candidate_query =
    Eigen::Translation3d(0.2, 0.1, -0.3) * Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY());

View<> camera_view() {
  View<> view;
  view.camera = {500.0, 500.0, 319.5, 239.5, 640, 480};
  return view;
}

std::vector<SemanticNode<>> desk() {
  return {object_at(1, {-0.6, 0, 3}), object_at(2, {0.5, 0.2, 2.5}), object_at(3, {0, -0.6, 2.8}),
          object_at(4, {0.1, 0.5, 3.2})};
}

/// What changed between the two layouts, both in the candidate's frame.
std::vector<ObjectChange> changes(std::vector<SemanticNode<>> before,
                                  std::vector<SemanticNode<>> after, bool with_views = true,
                                  const ChangeOptions& options = {}) {
  std::vector<View<>> views;
  if (with_views) views.push_back(camera_view());
  const TopologyGraph<> candidate(std::move(before), {}, views);
  const TopologyGraph<> there =
      moved(TopologyGraph<>(std::move(after)), T_candidate_query.inverse());
  const TopologyGraph<> query(there.nodes(), {}, views);
  RelativePose pose;
  pose.T_candidate_query = T_candidate_query;
  for (std::size_t i = 0; i < 4; ++i) pose.inliers.push_back({node_index(i), node_index(i)});
  pose.missing = MissingObjects{}.find(candidate, query, pose.inliers, T_candidate_query);
  return what_changed(candidate, query, pose, options);
}

std::vector<SemanticNode<>> desk_and(const SemanticNode<>& object) {
  auto nodes = desk();
  nodes.push_back(object);
  return nodes;
}

const SemanticNode<> cup = object_at(9, {-0.3, 0.3, 2.6});
const SemanticNode<> cup_elsewhere = object_at(9, {0.6, -0.4, 2.6});

}  // namespace

TEST_CASE("nothing changed on a desk that stayed as it was", "[recognition]") {
  CHECK(changes(desk(), desk()).empty());
  CHECK(changes(desk_and(cup), desk_and(cup)).empty());
  // Under another name it is still there.
  SemanticNode<> bowl = cup;
  bowl.label = ClassId{8};
  CHECK(changes(desk_and(cup), desk_and(bowl)).empty());
}

TEST_CASE("an object that was taken away is gone, one that was put there appeared",
          "[recognition]") {
  const auto gone = changes(desk_and(cup), desk());
  REQUIRE(gone.size() == 1);
  CHECK(gone[0].kind == ChangeKind::gone);
  CHECK(gone[0].label == cup.label);
  CHECK(gone[0].candidate == node_index(4));
  CHECK(gone[0].before == *cup.position);
  CHECK_FALSE(gone[0].query);
  CHECK_FALSE(gone[0].after);

  const auto appeared = changes(desk(), desk_and(cup));
  REQUIRE(appeared.size() == 1);
  CHECK(appeared[0].kind == ChangeKind::appeared);
  CHECK(appeared[0].query == node_index(4));
  REQUIRE(appeared[0].after);
  CHECK(appeared[0].after->isApprox(*cup.position, 1e-9));
  CHECK_FALSE(appeared[0].before);
}

TEST_CASE("an object that stands elsewhere was moved", "[recognition]") {
  const auto found = changes(desk_and(cup), desk_and(cup_elsewhere));
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == ChangeKind::moved);
  CHECK(found[0].before == *cup.position);
  REQUIRE(found[0].after);
  CHECK(found[0].after->isApprox(*cup_elsewhere.position, 1e-9));

  ChangeOptions near;
  near.max_move = 0.5;
  const auto two = changes(desk_and(cup), desk_and(cup_elsewhere), true, near);
  REQUIRE(two.size() == 2);
  CHECK(two[0].kind == ChangeKind::appeared);
  CHECK(two[1].kind == ChangeKind::gone);
}

TEST_CASE("another class was not moved there, unless they are one group", "[recognition]") {
  SemanticNode<> glass = cup_elsewhere;
  glass.label = ClassId{10};
  CHECK(changes(desk_and(cup), desk_and(glass)).size() == 2);
  ChangeOptions options;
  options.classes.join(cup.label, glass.label);
  const auto found = changes(desk_and(cup), desk_and(glass), true, options);
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == ChangeKind::moved);
  CHECK(found[0].label == glass.label);
}

TEST_CASE("what no camera could have shown is no change", "[recognition]") {
  CHECK(changes(desk_and(cup), desk(), false).empty());
  CHECK(changes(desk_and(object_at(9, {6, 0, 3})), desk()).empty());  // beside the image
  // Moved there from a place that the query does not see: it appeared.
  const auto found = changes(desk_and(object_at(9, {6, 0, 3})), desk_and(cup));
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == ChangeKind::appeared);
}

TEST_CASE("of several moves the shortest are paired first", "[recognition]") {
  auto before = desk_and(cup), after = desk_and(cup_elsewhere);
  before.push_back(object_at(9, {0.62, -0.05, 2.6}));  // 0.35 m from where one stands now
  const auto found = changes(before, after);
  REQUIRE(found.size() == 2);
  CHECK(found[0].kind == ChangeKind::moved);
  CHECK(found[0].candidate == node_index(5));
  CHECK(found[1].kind == ChangeKind::gone);
  CHECK(found[1].candidate == node_index(4));
}

TEST_CASE("every kind of change has words of its own", "[recognition]") {
  std::set<std::string> words;
  for (const ChangeKind kind : {ChangeKind::moved, ChangeKind::appeared, ChangeKind::gone}) {
    words.insert(to_string(kind));
  }
  CHECK(words.size() == 3);
}
