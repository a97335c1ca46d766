// SPDX-License-Identifier: MIT
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include <topobag/graph/local_graph.hpp>

#include "catch.hpp"
#include "graph/flickering_scene.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

std::optional<std::size_t> refused_node(const std::function<void()>& add) {
  try {
    add();
  } catch (const InvalidValue& error) {
    return error.index();
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("bad data is refused and changes nothing", "[graph]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SemanticNode<> object = object_at(1, {0, 0, 2});
  Eigen::Isometry3d bad_pose = still;
  bad_pose.translation().x() = nan;
  LocalGraph<> local;
  CHECK_THROWS_AS(local.add(nan, {object}, still), InvalidValue);
  CHECK(local.view_count() == 0);
  local.add(1.0, {object}, bad_pose);  // of the first key frame: ignored
  const Eigen::Isometry3d step(Eigen::Translation3d(0, 0, 1));
  CHECK_THROWS_AS(local.add(0.9, {object}, step), InvalidValue);
  CHECK_THROWS_AS(local.add(std::numeric_limits<double>::infinity(), {object}, step), InvalidValue);
  CHECK_THROWS_AS(local.add(1.1, {object}, bad_pose), InvalidValue);
  Eigen::Isometry3d mirrored = step, scaled = step;
  mirrored.linear()(2, 2) = -1.0;
  scaled.linear() *= 2.0;
  CHECK_THROWS_AS(local.add(1.1, {object}, mirrored), InvalidValue);
  CHECK_THROWS_AS(local.add(1.1, {object}, scaled), InvalidValue);
  CHECK_THROWS_AS(local.add(1.3e18, {object}, step), InvalidValue);  // nanoseconds
  CHECK(local.view_count() == 1);
  REQUIRE(local.objects().size() == 1);
  CHECK(local.objects()[0].second.position->isApprox(*object.position));
  local.add(1.0, {}, still);  // the same stamp is no step back
}

TEST_CASE("a node that is not finite is refused by its index", "[graph][regression]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SemanticNode<> bad = object_at(1, {0, 0, 2});
  bad.position->y() = nan;
  LocalGraph<> local;
  local.add(0.0, {object_at(1, {0, 0, 2})}, still);
  const Eigen::Isometry3d step(Eigen::Translation3d(0, 0, 1));
  CHECK(refused_node([&] { local.add(0.1, {object_at(2, {1, 0, 2}), bad}, step); }) == 1U);
  REQUIRE(local.graph().size() == 1);
  CHECK(local.graph().nodes()[0].position->isApprox(Eigen::Vector3d(0, 0, 2)));
}

TEST_CASE("a camera that is not finite is refused, an unknown one is not", "[graph][regression]") {
  LocalGraph<> local;
  View<> view = camera_view();
  view.camera.cx = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(local.add(0.0, {object_at(1, {0, 0, 2})}, still, view), InvalidValue);
  CHECK(local.view_count() == 0);
  local.add(0.0, {object_at(1, {0, 0, 2})}, still, View<>{});
  CHECK(local.graph().size() == 1);
}

TEST_CASE("a covariance without an inverse is refused and swallows no object",
          "[graph][regression]") {
  LocalGraph<> local;
  SemanticNode<> flat = object_at(1, {0, 0, 2});
  flat.covariance = Eigen::Vector3d(0, 0, 0.04).asDiagonal();
  CHECK(refused_node([&] { local.add(0.0, {flat}, still); }) == 0U);
  local.add(0.1, {object_at(1, {0, 0, 2}), object_at(2, {1, 0, 2})}, still);
  CHECK(local.graph().size() == 2);
}

TEST_CASE("relative poses that rounding left askew do not add up", "[graph]") {
  LocalGraphOptions options;
  options.window = 1000.0;
  LocalGraph<> local(options);
  Eigen::Isometry3d askew = Eigen::Isometry3d::Identity();
  askew.linear() *= 1.0001;
  for (int i = 0; i < 200; ++i) local.add(i, {object_at(1, {0, 0, 2})}, askew);
  REQUIRE(local.graph().size() == 1);
  CHECK(local.graph().nodes()[0].position->isApprox(Eigen::Vector3d(0, 0, 2), 1e-6));
}

TEST_CASE("key frames that describe objects by another method are refused", "[graph][appearance]") {
  LocalGraph<> local;
  SemanticNode<> cup = object_at(1, {0, 0, 2});
  local.add(0.0, {cup}, still);
  cup.appearance = Appearance(AppearanceKind("a", 2), Appearance::Bytes{1, 2});
  local.add(0.1, {cup}, still);
  SemanticNode<> other = cup;
  other.appearance = Appearance(AppearanceKind("b", 2), Appearance::Bytes{1, 2});
  CHECK_THROWS_AS(local.add(0.2, {other}, still), InvalidValue);
  CHECK(refused_node([&] { local.add(0.2, {cup, other}, still); }) == 1U);
  CHECK(local.view_count() == 2);
  local.add(0.2, {object_at(1, {0, 0, 2})}, still);
  REQUIRE(local.graph().size() == 1);
  CHECK(local.graph().appearance_kind() == cup.appearance.kind());
}

TEST_CASE("a view that no graph takes is refused before it is in the window",
          "[graph][regression]") {
  LocalGraph<> local;
  View<> view;
  view.occluders.push_back({{0.0, 0.0, 10.0, 10.0}, std::nan("")});
  CHECK_THROWS_AS(local.add(0.0, {}, Eigen::Isometry3d::Identity(), view), InvalidValue);
  CHECK(local.view_count() == 0);
  CHECK_NOTHROW(local.graph());
}
