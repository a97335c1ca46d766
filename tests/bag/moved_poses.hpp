// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <topobag/bag/camera_poses.hpp>
#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/place_contents.hpp>

#include "catch.hpp"
#include "error_text.hpp"
#include "random_graphs.hpp"

/// A camera in a flat of 24 × 24 × 6 m.
inline Eigen::Isometry3d camera_in_flat(std::mt19937& random) {
  std::uniform_real_distribution<double> metres(-12.0, 12.0), radians(-3.0, 3.0);
  const double x = metres(random), y = metres(random), z = 0.25 * metres(random);
  return Eigen::Translation3d(x, y, z) *
         Eigen::AngleAxisd(radians(random), Eigen::Vector3d::UnitY());
}

/// That a bag finds the cameras of a region that a walk through all entries finds.
template <typename Bag>
void check_within(const Bag& bag, const topobag::MapRegion& region) {
  using namespace topobag;
  std::vector<KeyframeId> inside;
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>&) {
    if (info.T_world_camera && region.contains(info.T_world_camera->translation()))
      inside.push_back(id);
  });
  CHECK(bag.within(region) == inside);
}

/// That two bags hold the same, and answer alike.
template <typename A, typename B>
void check_same_map(const A& a, const B& b, std::mt19937& random) {
  using namespace topobag;
  REQUIRE(a.size() == b.size());
  CHECK(a.places() == b.places());
  a.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    const auto other = b.info(id);
    REQUIRE(other);
    CHECK(info.stamp == other->stamp);
    CHECK(info.session == other->session);
    CHECK(info.label == other->label);
    REQUIRE(info.T_world_camera.has_value() == other->T_world_camera.has_value());
    if (info.T_world_camera) {
      CHECK(info.T_world_camera->translation() == other->T_world_camera->translation());
      CHECK(info.T_world_camera->isApprox(*other->T_world_camera, 1e-12));
    }
    CHECK(b.find(id)->size() == graph.size());
    CHECK(a.places_holding(class_counts(graph.nodes())) ==
          b.places_holding(class_counts(graph.nodes())));
  });
  for (int i = 0; i < 4; ++i) {
    QueryOptions options;
    options.max_results = 6;
    const auto graph = random_graph(random, 6, 4, false);
    CHECK(a.query(graph, options) == b.query(graph, options));
    options.among.region = MapRegion{camera_in_flat(random).translation(), 6.0};
    CHECK(a.query(graph, options) == b.query(graph, options));
    check_within(a, *options.among.region);
    check_within(b, *options.among.region);
  }
}

/// That `set_poses` leaves the bag as `update` of each key frame does.
/// @param moved, updated  two empty bags
template <typename Bag>
void check_set_poses(Bag& moved, Bag& updated, std::size_t entries) {
  using namespace topobag;
  std::mt19937 random(11);
  std::bernoulli_distribution half(0.5);
  for (std::uint64_t id = 0; id < entries; ++id) {
    EntryInfo info;
    info.session = static_cast<std::uint32_t>(id % 3);
    info.stamp = static_cast<double>(id);
    if (half(random)) info.T_world_camera = camera_in_flat(random);
    const auto graph = random_graph(random, 5, 4, false);
    for (Bag* bag : {&moved, &updated}) bag->add(KeyframeId{id}, graph, info);
  }
  moved.erase(KeyframeId{3});
  updated.erase(KeyframeId{3});
  for (int round = 0; round < 3; ++round) {
    CameraPoses poses;
    for (std::uint64_t id = 0; id < entries; ++id) {
      if (id != 3 && half(random)) poses.emplace(KeyframeId{id}, camera_in_flat(random));
    }
    moved.set_poses(poses);
    for (const auto& [id, T_world_camera] : poses) {
      EntryInfo info = *updated.info(id);
      info.T_world_camera = T_world_camera;
      updated.update(id, *updated.find(id), info);
    }
    check_same_map(moved, updated, random);
  }
  // What is refused changes nothing.
  const std::size_t places = moved.places();
  CameraPoses bad{{KeyframeId{1}, camera_in_flat(random)}, {KeyframeId{3}, camera_in_flat(random)}};
  const std::string missing = error_text([&] { moved.set_poses(bad); });
  CHECK(missing.find("key frame 3 is not in the bag") != std::string::npos);
  bad = {{KeyframeId{1}, camera_in_flat(random)}, {KeyframeId{2}, Eigen::Isometry3d::Identity()}};
  bad.at(KeyframeId{2}).linear() *= 2.0;
  const std::string unrigid = error_text([&] { moved.set_poses(bad); });
  CHECK(unrigid.find("key frame 2: the pose is no rigid motion") != std::string::npos);
  CHECK(moved.places() == places);
  check_same_map(moved, updated, random);
}
