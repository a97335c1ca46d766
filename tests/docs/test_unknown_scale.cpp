// SPDX-License-Identifier: MIT
// What the page unknown_scale.md shows.
#include <random>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/graph/scaled_graph.hpp>
#include <topobag/recognition/align_maps.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

TEST_CASE("a front end without scale finds itself and its scale", "[docs]") {
  std::mt19937 random(22);
  const SyntheticRoom room(4, 9, 5);
  BagOfTopologyGraphs<> map;
  const Eigen::Isometry3d T_room_candidate = random_camera(random);
  map.add(KeyframeId{0}, room.seen_from(T_room_candidate), standing_at(T_room_candidate));
  const Eigen::Isometry3d T_room_query = random_camera(random);
  const TopologyGraph<> query = scaled(room.seen_from(T_room_query), 1.0 / 0.71);
  std::size_t used = 0;
  const auto use = [&](const Eigen::Isometry3d& T_candidate_query, double scale) {
    ++used;
    const Eigen::Isometry3d T = T_room_candidate * T_candidate_query;
    CHECK((T.translation() - T_room_query.translation()).norm() < 0.05);
    CHECK(scale == Approx(0.71).epsilon(0.02));
  };
  RecognitionOptions options = recognition_options(ClassCatalog::coco80());
  // 1 unit of the query is a quarter to four metres of the map
  options.matching.scale = ScaleRange{};
  const Relocalizer lost(map, options);
  const Recognition found = lost.localize(query);
  if (found) use(found.accepted->pose->T_candidate_query, found.accepted->pose->scale);
  CHECK(used == 1);

  BagOfTopologyGraphs<> other;  // in a unit of .71 m, about another origin
  const Eigen::Isometry3d T_map_other(Eigen::Translation3d(3.0, -1.0, 0.5));
  for (unsigned i = 0; i < 4; ++i) {
    const Eigen::Isometry3d T_room_camera = random_camera(random);
    Eigen::Isometry3d T_other_camera = T_map_other.inverse() * T_room_camera;
    T_other_camera.translation() /= 0.71;
    other.add(KeyframeId{10 + i}, scaled(room.seen_from(T_room_camera), 1.0 / 0.71),
              standing_at(T_other_camera));
  }
  AlignOptions align;
  align.recognition = options;  // with its range of scales
  const MapAlignment alignment = align_maps(map, other, align);
  // graphs and poses come in in the map's metres
  if (alignment) map.merge(other, alignment.merge_options(1));
  REQUIRE(map.size() == 5);
  CHECK(alignment.scale == Approx(0.71).epsilon(0.01));
  CHECK(map.info(KeyframeId{10})->session == 1);
  CHECK(map.info(KeyframeId{10})->T_world_camera->translation().norm() < 1.5);
}
