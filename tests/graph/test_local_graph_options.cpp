// SPDX-License-Identifier: MIT
#include <cstddef>

#include <Eigen/Geometry>

#include <topobag/graph/local_graph.hpp>
#include <topobag/graph/local_graph_options.hpp>

#include "catch.hpp"
#include "graph/flickering_scene.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

/// Objects after two sightings so far apart, of classes 1 and `second`.
std::size_t objects_of_two(double metres, int second, const LocalGraphOptions& options) {
  LocalGraph<> local(options);
  local.add(0.0, {object_at(1, {0, 0, 2})}, still);
  local.add(0.1, {object_at(second, {metres, 0, 2})}, still);
  return local.objects().size();
}

}  // namespace

TEST_CASE("sightings join within the gate of their classes", "[graph]") {
  LocalGraphOptions options;
  options.merge = SameObject{1e-9};
  options.merge_gate = 0.0;
  // 2 cm along each axis, and as much again: 5.7 cm are two deviations of the difference.
  CHECK(objects_of_two(0.057, 1, options) == 1);
  CHECK(objects_of_two(0.057, 2, options) == 2);
  options.other_class_gate = 3.0;
  CHECK(objects_of_two(0.057, 2, options) == 1);
  options.gate = 1.0;
  CHECK(objects_of_two(0.057, 1, options) == 2);
}

TEST_CASE("views older than the window count no more", "[graph]") {
  for (const double window : {0.5, 1.0, 3.0}) {
    LocalGraphOptions options;
    options.window = window;
    LocalGraph<> local(options);
    for (int i = 0; i <= 40; ++i) local.add(0.125 * i, {}, still);
    CHECK(local.view_count() == static_cast<std::size_t>(window / 0.125) + 1);
  }
}

TEST_CASE("objects that too few of the views due have seen are dropped", "[graph]") {
  for (const double least : {0.2, 0.5, 0.9}) {
    LocalGraphOptions options;
    options.min_existence = least;
    LocalGraph<> local(options);
    for (int i = 0; i < 10; ++i) {
      std::vector<SemanticNode<>> seen;
      if (i < 4) seen.push_back(object_at(1, {0, 0, 2}));  // by 40 % of the views
      local.add(0.1 * i, seen, still, camera_view());
    }
    CHECK(local.objects().size() == (least < 0.4 ? 1U : 0U));
  }
}
