// SPDX-License-Identifier: MIT
// Two maps, one of which does not know its unit.
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/graph/scaled_graph.hpp>
#include <topobag/recognition/align_maps.hpp>

#include "catch.hpp"
#include "recognition/drawn_sim3.hpp"
#include "synthetic_room.hpp"

using namespace topobag;

namespace {

/// Rooms 8 m apart, by their seeds, each seen by three cameras with the noise that its nodes state;
/// the map is in the unit of b, and its world lies in that of the building as `a_b` says.
BagOfTopologyGraphs<> map_in_unit(const std::vector<unsigned>& seeds,
                                  const detail::Sim3WithCovariance& a_b, std::mt19937& random) {
  BagOfTopologyGraphs<> bag;
  std::uint64_t id = 0;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Eigen::Translation3d T_building_room(8.0 * static_cast<double>(i), 0.0, 0.0);
    for (int camera = 0; camera < 3; ++camera) {
      const Eigen::Isometry3d T_room_camera = random_camera(random);
      auto nodes = SyntheticRoom(seeds[i], 9, 6).seen_from(T_room_camera).nodes();
      for (auto& node : nodes) {
        const Eigen::Vector3d error = drawn_zeta(random).head<3>();
        *node.position += node.covariance.llt().matrixL() * error;
        node.z = node.position->z();
      }
      Eigen::Isometry3d T_b_camera = a_b.T.inverse() * T_building_room * T_room_camera;
      T_b_camera.translation() /= a_b.scale;
      bag.add(KeyframeId{id++},
              scaled(make_topology_graph(std::move(nodes), KnnEdges{}), 1.0 / a_b.scale),
              standing_at(T_b_camera));
    }
  }
  return bag;
}

BagOfTopologyGraphs<> map_in_metres(const std::vector<unsigned>& seeds, std::mt19937& random) {
  return map_in_unit(seeds, {}, random);
}

AlignOptions unknown_unit() {
  AlignOptions options;
  options.recognition.matching.scale = ScaleRange{};
  return options;
}

/// Of pose and scale together, by all that is said of their errors.
double squared_deviations(const MapAlignment& alignment, const detail::Sim3WithCovariance& truth) {
  RelativePose said;
  said.T_candidate_query = alignment.T_a_b->T;
  said.covariance = alignment.T_a_b->covariance;
  said.scale = alignment.scale;
  said.scale_deviation = alignment.scale_deviation;
  said.scale_covariance = alignment.scale_covariance;
  const auto motion = detail::Sim3WithCovariance::of(said);
  const auto zeta = detail::error_between(truth, motion);
  return zeta.dot(motion.covariance.llt().solve(zeta));
}

}  // namespace

TEST_CASE("a map in an unknown unit is laid over one in metres, as exactly as is said",
          "[recognition]") {
  std::mt19937 random(2250);
  const int rounds = 25;
  double of_scale = 0.0, of_all = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const detail::Sim3WithCovariance a_b = drawn_sim3(random);
    const auto a = map_in_metres({1, 2, 3, 4}, random);
    const auto b = map_in_unit({1, 2, 3, 4}, a_b, random);
    CAPTURE(round, a_b.scale);
    if (std::abs(std::log(a_b.scale)) > 0.3) CHECK_FALSE(align_maps(a, b));
    const MapAlignment alignment = align_maps(a, b, unknown_unit());
    REQUIRE(alignment);
    CHECK(alignment.agreeing >= 8);
    CHECK(alignment.places >= 4);
    REQUIRE(alignment.scale_deviation > 0.0);
    CHECK(alignment.scale_deviation < 0.01 * alignment.scale);
    const double off = (alignment.scale - a_b.scale) / alignment.scale_deviation;
    CHECK(std::abs(off) < 4.0);
    of_scale += off * off / rounds;
    of_all += squared_deviations(alignment, a_b) / rounds;
  }
  CHECK(of_scale > 0.15);  // key frames of one place count as one, though their noise differs
  CHECK(of_scale < 1.5);
  CHECK(of_all > 7.0 * 0.15);
  CHECK(of_all < 7.0 * 1.5);
}

TEST_CASE("the other way round the unit is the inverse", "[recognition]") {
  std::mt19937 random(2251);
  const detail::Sim3WithCovariance a_b = drawn_sim3(random);
  const auto a = map_in_metres({1, 2, 3, 4}, random);
  const auto b = map_in_unit({1, 2, 3, 4}, a_b, random);
  const MapAlignment forth = align_maps(a, b, unknown_unit());
  const MapAlignment back = align_maps(b, a, unknown_unit());
  REQUIRE(forth);
  REQUIRE(back);
  CHECK(forth.scale * back.scale == Approx(1.0).margin(0.02));
  const Eigen::Vector3d x_b(1.0, -2.0, 0.5);
  const Eigen::Vector3d x_a = forth.T_a_b->T * (forth.scale * x_b);
  CHECK((back.T_a_b->T * (back.scale * x_a) - x_b).norm() < 0.2 / a_b.scale);
}

TEST_CASE("maps of different buildings fit at no scale, look-alike ones at several places",
          "[recognition]") {
  std::mt19937 random(2252);
  for (int round = 0; round < 5; ++round) {
    const detail::Sim3WithCovariance a_b = drawn_sim3(random);
    const auto a = map_in_metres({1, 2, 3}, random);
    const auto elsewhere = map_in_unit({11, 12, 13}, a_b, random);
    CHECK(align_maps(a, elsewhere, unknown_unit()).verdict == AlignmentVerdict::too_few);
    const auto wings = map_in_metres({1, 2, 9, 1, 2}, random);
    const auto wing = map_in_unit({1, 2}, a_b, random);
    CHECK(align_maps(wings, wing, unknown_unit()).verdict == AlignmentVerdict::ambiguous);
  }
}

TEST_CASE("rooms each in a unit of their own do not agree on one", "[recognition]") {
  // Rooms at four scales: every match is verified, and no one unit explains two of them.
  std::mt19937 random(2253);
  const auto a = map_in_metres({1, 2, 3, 4}, random);
  BagOfTopologyGraphs<> b;
  std::uint64_t id = 0;
  const double units[] = {0.5, 0.8, 1.3, 2.0};
  for (std::size_t room = 0; room < 4; ++room) {
    const detail::Sim3WithCovariance a_room{Eigen::Isometry3d::Identity(), units[room]};
    std::vector<unsigned> seeds(4, 100);
    seeds[room] = static_cast<unsigned>(room + 1);
    const auto whole = map_in_unit(seeds, a_room, random);
    for (std::uint64_t k = 3 * room; k < 3 * room + 3; ++k) {
      auto info = *whole.info(KeyframeId{k});
      info.T_world_camera->translation() *= units[room];  // the cameras know where they are
      b.add(KeyframeId{id++}, *whole.find(KeyframeId{k}), info);
    }
  }
  const MapAlignment alignment = align_maps(a, b, unknown_unit());
  CHECK(alignment.matched >= 10);
  CHECK(alignment.agreeing <= 3);
}

TEST_CASE("a known unit is one, also where it is asked for", "[recognition]") {
  std::mt19937 random(2254);
  const detail::Sim3WithCovariance a_b{drawn_sim3(random).T, 1.0};
  const auto a = map_in_metres({1, 2, 3, 4}, random);
  const auto b = map_in_unit({1, 2, 3, 4}, a_b, random);
  const MapAlignment known = align_maps(a, b), asked = align_maps(a, b, unknown_unit());
  REQUIRE(known);
  REQUIRE(asked);
  CHECK(known.scale == 1.0);
  CHECK(known.scale_deviation == 0.0);
  CHECK(known.scale_covariance.isZero(0.0));
  CHECK(std::abs(asked.scale - 1.0) < 4.0 * asked.scale_deviation);
  CHECK((asked.T_a_b->T.translation() - known.T_a_b->T.translation()).norm() < 0.1);
}

TEST_CASE("a map in an unknown unit comes into one in metres as if it had been in metres",
          "[recognition]") {
  std::mt19937 random(2255);
  const detail::Sim3WithCovariance a_b = drawn_sim3(random);
  const auto a = map_in_metres({1, 2, 3, 4}, random);
  const auto b = map_in_unit({1, 2, 3, 4}, a_b, random);
  const MapAlignment alignment = align_maps(a, b, unknown_unit());
  REQUIRE(alignment);
  IndexedBag joined;
  joined.merge(a);
  const auto new_ids = joined.merge(b, alignment.merge_options(3));
  REQUIRE(joined.size() == 24);
  b.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    const EntryInfo now = *joined.info(new_ids.at(id));
    CHECK(now.session == 3);
    const Eigen::Isometry3d truth = detail::camera_in(a_b, *info.T_world_camera);
    CHECK((now.T_world_camera->translation() - truth.translation()).norm() < 0.1);
    CHECK(joined.find(new_ids.at(id))->nodes()[0].size.x() ==
          Approx(a_b.scale * graph.nodes()[0].size.x()).epsilon(0.02));
  });
  // A query in metres then finds both visits where they are.
  const Relocalizer relocalizer(joined);
  const auto found = relocalizer.localize(SyntheticRoom(2, 9, 6).seen_from(random_camera(random)));
  REQUIRE(found);
  CHECK(found.accepted->pose->scale == 1.0);
}
