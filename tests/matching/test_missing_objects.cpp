// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <topobag/matching/missing_objects.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

View<> camera_view() {
  View<> view;
  view.camera = {500.0, 500.0, 319.5, 239.5, 640, 480};
  return view;
}

/// A candidate that holds one object, and what becomes of it when the query, with `views`, holds
/// `others`.
std::vector<MissingObject> look_for(const SemanticNode<>& object, std::vector<View<>> views,
                                    std::vector<SemanticNode<>> others = {},
                                    const Eigen::Isometry3d& T = Eigen::Isometry3d::Identity()) {
  const TopologyGraph<> candidate({object});
  const TopologyGraph<> query(std::move(others), {}, std::move(views));
  return MissingObjects{}.find(candidate, query, {}, T);
}

const SemanticNode<> ahead = object_at(1, {0, 0, 3});

}  // namespace

TEST_CASE("a plain object that is missing costs what it was worth", "[matching]") {
  SemanticNode<> doubtful = ahead;
  doubtful.existence = 0.3;
  const auto missing = look_for(doubtful, {camera_view()});
  REQUIRE(missing.size() == 1);
  CHECK(missing[0].node == node_index(0));
  CHECK(missing[0].of_candidate);
  CHECK(missing[0].views == 1);
  CHECK(missing[0].cost == Approx(-std::log10(0.7)));
}

TEST_CASE("more views repeat the oversight", "[matching]") {
  SemanticNode<> doubtful = ahead;
  doubtful.existence = 0.2;
  const auto missing = look_for(doubtful, {camera_view(), camera_view(), camera_view()});
  REQUIRE(missing.size() == 1);
  CHECK(missing[0].views == 3);
  // What one look of a visit overlooks, the others overlook as well.
  CHECK(missing[0].cost == Approx(-std::log10(0.8)));
}

TEST_CASE("the less the views repeat each other, the more they count", "[matching]") {
  SemanticNode<> doubtful = ahead;
  doubtful.existence = 0.2;
  MissingObjects options;
  options.correlation = 0.75;
  const TopologyGraph<> query({}, {}, {camera_view(), camera_view(), camera_view()});
  const auto missing =
      options.find(TopologyGraph<>({doubtful}), query, {}, Eigen::Isometry3d::Identity());
  REQUIRE(missing.size() == 1);
  CHECK(missing[0].cost == Approx(-1.5 * std::log10(0.8)));
}

TEST_CASE("the cost of an object is bounded: it may have been moved", "[matching]") {
  const auto missing = look_for(ahead, std::vector<View<>>(20, camera_view()));
  REQUIRE(missing.size() == 1);
  CHECK(missing[0].cost == Approx(-std::log10(MissingObjects{}.min_probability)));
}

TEST_CASE("what no view could show is not missing", "[matching]") {
  CHECK(look_for(ahead, {camera_view()}).size() == 1);
  CHECK(look_for(ahead, {}).empty());                                   // no views
  CHECK(look_for(ahead, {View<>{}}).empty());                           // an image of unknown size
  CHECK(look_for(object_at(1, {0, 0, 5.1}), {camera_view()}).empty());  // too far away
  CHECK(look_for(object_at(1, {0, 0, 4.9}), {camera_view()}).size() == 1);
  CHECK(look_for(object_at(1, {0, 0, -3}), {camera_view()}).empty());    // behind the camera
  CHECK(look_for(object_at(1, {2.5, 0, 3}), {camera_view()}).empty());   // beside the image
  CHECK(look_for(object_at(1, {1.75, 0, 3}), {camera_view()}).empty());  // 28 px from its border
  CHECK(look_for(object_at(1, {1.6, 0, 3}), {camera_view()}).size() == 1);
  SemanticNode<> unplaced = ahead;
  unplaced.position.reset();
  CHECK(look_for(unplaced, {camera_view()}).empty());
}

TEST_CASE("what lies behind an occluder is not missing", "[matching]") {
  const auto with_occluder = [](const BoundingBox& box, double z) {
    View<> view = camera_view();
    view.occluders.push_back({box, z});
    return look_for(ahead, {view}).size();
  };
  const BoundingBox middle{300, 220, 340, 260}, corner{0, 0, 100, 100};
  CHECK(with_occluder(middle, 1.0) == 0);
  CHECK(with_occluder(middle, 0.0) == 0);  // unknown depth
  CHECK(with_occluder(middle, 4.0) == 1);
  CHECK(with_occluder(middle, 2.9) == 1);  // as far away as the object
  CHECK(with_occluder(corner, 1.0) == 1);
}

TEST_CASE("an object found under another name is not missing", "[matching]") {
  // Reach: 0.1 m and half the object's diagonal.
  const double reach = 0.1 + 0.5 * std::sqrt(0.08);
  CHECK(look_for(ahead, {camera_view()}, {object_at(2, {0, reach - 0.01, 3})}).empty());
  // Further away both are missing, of which only the candidate's can be looked for.
  CHECK(look_for(ahead, {camera_view()}, {object_at(2, {0, reach + 0.01, 3})}).size() == 1);
}

TEST_CASE("missing objects are looked for where the pose puts them, both ways", "[matching]") {
  const Eigen::Isometry3d T_candidate_query(Eigen::Translation3d(0, 0, 2));
  // 4 m ahead of the candidate's camera, 2 m ahead of the query's; and the other way round.
  const TopologyGraph<> candidate({ahead, object_at(2, {0, 1, 4})}, {}, {camera_view()});
  const TopologyGraph<> query({object_at(1, {0, 0, 1}), object_at(3, {0, -0.5, 2})}, {},
                              {camera_view()});
  const auto missing =
      MissingObjects{}.find(candidate, query, {{node_index(0), node_index(0)}}, T_candidate_query);
  REQUIRE(missing.size() == 1);  // at 250 px below the middle the query's view shows nothing
  CHECK_FALSE(missing[0].of_candidate);
  CHECK(missing[0].node == node_index(1));

  const auto all = MissingObjects{}.find(candidate, query, {}, T_candidate_query);
  CHECK(all.size() == 1);  // the first ones lie on one another

  const Eigen::Isometry3d far(Eigen::Translation3d(0, 0, -20));
  CHECK(MissingObjects{}.find(candidate, query, {}, far).empty());
}

TEST_CASE("with depth an object is missing where the camera looked through its place",
          "[matching]") {
  const auto with_depth = [](std::optional<double> metres) {
    View<> view = camera_view();
    view.depth.emplace([=](const Eigen::Vector2d&) { return metres; }, 640, 480);
    return look_for(ahead, {view});
  };
  // Clearance: 0.15 m and half the object's diagonal.
  const double beyond = 3.0 + 0.15 + 0.5 * std::sqrt(0.08);
  const auto missing = with_depth(beyond * std::exp2(1.0 / DepthGrid::levels_per_octave));
  REQUIRE(missing.size() == 1);
  CHECK(missing[0].views == 1);
  CHECK(missing[0].measured_views == 1);
  CHECK(with_depth(beyond - 0.01).empty());  // a surface where it should be
  CHECK(with_depth(1.0).empty());            // hidden
  CHECK(with_depth(std::nullopt).empty());   // not measured

  // Beside a view without depth, which goes by boxes.
  View<> measured = camera_view();
  measured.depth.emplace([](const Eigen::Vector2d&) { return std::make_optional(4.0); }, 640, 480);
  const auto both = look_for(ahead, {camera_view(), measured});
  REQUIRE(both.size() == 1);
  CHECK(both[0].views == 2);
  CHECK(both[0].measured_views == 1);
}

TEST_CASE("a class is missed at its own rate where that is known", "[matching]") {
  const TopologyGraph<> candidate({ahead});
  const TopologyGraph<> query({}, {}, {camera_view()});
  MissingObjects missing;
  missing.detection_rates[ahead.label] = 0.25;
  const auto found = missing.find(candidate, query, {}, Eigen::Isometry3d::Identity());
  REQUIRE(found.size() == 1);
  CHECK(found[0].cost == Approx(-std::log10(0.75)));
}
