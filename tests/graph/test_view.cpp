// SPDX-License-Identifier: MIT
#include <optional>

#include <topobag/graph/view.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

View<> plain_view() {
  View<> view;
  view.camera = {100.0, 100.0, 50.0, 50.0, 101, 101};
  return view;
}

}  // namespace

TEST_CASE("a view should show what lies in its image, margin and range", "[graph]") {
  const View<> view = plain_view();
  CHECK(view.should_show({0, 0, 2}, 10.0, 5.0));
  CHECK(view.should_show({0.79, 0, 2}, 10.0, 5.0));  // 39.5 px right of the middle
  CHECK_FALSE(view.should_show({0.81, 0, 2}, 10.0, 5.0));
  CHECK_FALSE(view.should_show({0, -0.81, 2}, 10.0, 5.0));
  CHECK(view.should_show({0, 0, 5}, 10.0, 5.0));
  CHECK_FALSE(view.should_show({0, 0, 5.01}, 10.0, 5.0));
  CHECK_FALSE(view.should_show({0, 0, -1}, 10.0, 5.0));
  CHECK_FALSE(view.should_show({0, 0, 0}, 10.0, 5.0));
  CHECK_FALSE(View<>{}.should_show({0, 0, 2}, 0.0, 5.0));
}

TEST_CASE("a view looks from where its camera is", "[graph]") {
  View<> view = plain_view();
  view.T_graph_camera = Eigen::Translation3d(0, 0, 3) *
                        Eigen::AngleAxisd(3.141592653589793, Eigen::Vector3d::UnitY());
  CHECK(view.should_show({0, 0, 1}, 0.0, 5.0));
  CHECK_FALSE(view.should_show({0, 0, 4}, 0.0, 5.0));
  // At (1, 0, 3) it looks along x; the other way round, from the graph to the camera, along -x.
  view.T_graph_camera = Eigen::Translation3d(1, 0, 3) *
                        Eigen::AngleAxisd(1.5707963267948966, Eigen::Vector3d::UnitY());
  CHECK(view.should_show({3, 0, 3}, 0.0, 5.0));
  CHECK_FALSE(view.should_show({-1, 0, 3}, 0.0, 5.0));
}

TEST_CASE("an occluder hides what lies well behind it", "[graph]") {
  const auto shows = [](double occluder_z, double z) {
    View<> view = plain_view();
    view.occluders.push_back({{40, 40, 60, 60}, occluder_z});
    return view.should_show({0, 0, z}, 0.0, 5.0);
  };
  CHECK_FALSE(shows(1.0, 2.0));
  CHECK(shows(1.8, 2.0));  // the object's own box, or a neighbour's
  CHECK(shows(3.0, 2.0));
  CHECK_FALSE(shows(0.0, 2.0));  // of unknown depth
  View<> beside = plain_view();
  beside.occluders.push_back({{60, 60, 80, 80}, 1.0});
  CHECK(beside.should_show({0, 0, 2}, 0.0, 5.0));
}

TEST_CASE("a camera looks through what lies before the depth it measured", "[graph]") {
  View<> view = plain_view();
  CHECK_FALSE(view.sees_through({0, 0, 2}, 10.0, 5.0, 0.2));  // without depth
  const auto wall = [](const Eigen::Vector2d& pixel) {
    return pixel.x() < 60.0 ? std::make_optional(4.0) : std::nullopt;
  };
  view.depth.emplace(wall, 101, 101);
  view.occluders.push_back({{40, 40, 60, 60}, 0.0});  // a box does not undo a measurement
  CHECK(view.sees_through({0, 0, 2}, 10.0, 5.0, 0.2));
  CHECK(view.sees_through({0, 0, 3.79}, 10.0, 5.0, 0.2));
  CHECK_FALSE(view.sees_through({0, 0, 3.81}, 10.0, 5.0, 0.2));
  CHECK_FALSE(view.sees_through({0, 0, 4.5}, 10.0, 5.0, 0.2));   // behind the wall
  CHECK_FALSE(view.sees_through({0.4, 0, 2}, 10.0, 5.0, 0.2));   // nothing measured at 70 px
  CHECK_FALSE(view.sees_through({-0.9, 0, 2}, 10.0, 5.0, 0.2));  // too near the border
  CHECK_FALSE(view.sees_through({0, 0, 2}, 10.0, 1.9, 0.2));     // too far away
}

TEST_CASE("a view that no map could keep is none", "[graph][regression]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  View<> view = plain_view();
  CHECK_NOTHROW(view.validate());
  view.occluders.push_back({{40, 40, 60, 60}, nan});
  CHECK_THROWS_AS(view.validate(), InvalidValue);
  view = plain_view();
  view.camera.cx = nan;
  CHECK_THROWS_AS(view.validate(), InvalidValue);
  view = plain_view();
  view.T_graph_camera.linear() *= 2.0;
  CHECK_THROWS_AS(view.validate(), InvalidValue);
  view = plain_view();
  view.depth.emplace(DepthGrid::Levels{}, 640, 480);
  CHECK_THROWS_AS(view.validate(), InvalidValue);
}
