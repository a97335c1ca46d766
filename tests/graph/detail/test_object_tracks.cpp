// SPDX-License-Identifier: MIT
#include <cstddef>
#include <iterator>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/graph/detail/object_tracks.hpp>

#include "catch.hpp"
#include "matching/layouts.hpp"

using namespace topobag;

namespace {

std::vector<Eigen::Vector3d> fused_positions(const detail::ObjectTracks<double>& tracks) {
  std::vector<Eigen::Vector3d> positions;
  for (const auto& object : tracks) positions.push_back(*object.estimate.position);
  return positions;
}

}  // namespace

TEST_CASE("tracks that are moved lie where their objects are moved", "[graph]") {
  std::mt19937 random(81);
  for (int round = 0; round < 20; ++round) {
    detail::ObjectTracks<double> tracks{LocalGraphOptions{}};
    for (std::size_t view = 0; view < 3; ++view) {
      tracks.add(view, {object_at(1, {0, 0, 3}), object_at(2, {1, 0, 3}), object_at(3, {0, 1, 4})});
    }
    const auto before = fused_positions(tracks);
    REQUIRE(before.size() == 3);
    const Eigen::Isometry3d T = random_motion(random, 2.0);
    tracks.move(T);
    const auto after = fused_positions(tracks);
    for (std::size_t i = 0; i < 3; ++i) CHECK(after[i].isApprox(T * before[i], 1e-9));
  }
}

TEST_CASE("tracks keep the sightings from a view on, and go with their last one", "[graph]") {
  detail::ObjectTracks<double> tracks{LocalGraphOptions{}};
  tracks.add(0, {object_at(1, {0, 0, 3}), object_at(2, {1, 0, 3})});
  tracks.add(1, {object_at(1, {0, 0, 3})});
  tracks.forget_before(1);
  REQUIRE(std::distance(tracks.begin(), tracks.end()) == 1);
  CHECK(tracks.begin()->track.sightings.size() == 1);
  tracks.forget_before(2);
  CHECK(tracks.begin() == tracks.end());
}

TEST_CASE("an object's estimate stays what its sightings say together", "[graph]") {
  std::mt19937 random(82);
  std::normal_distribution<double> normal;
  std::bernoulli_distribution shown(0.7);
  const LocalGraphOptions options;
  detail::ObjectTracks<double> tracks(options);
  const std::vector<Eigen::Vector3d> places{{0, 0, 3}, {1, 0, 3}, {0, 1, 4}, {0.2, 0, 3}};
  Eigen::Isometry3d T_now_first = Eigen::Isometry3d::Identity();
  for (std::size_t view = 0; view < 40; ++view) {
    std::vector<SemanticNode<>> nodes;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!shown(random)) continue;
      const Eigen::Vector3d noise(normal(random), normal(random), normal(random));
      nodes.push_back(
          object_at(1 + static_cast<int>(i % 2), T_now_first * places[i] + 0.03 * noise));
    }
    tracks.add(view, nodes);
    if (view >= 5) tracks.forget_before(view - 5);
    const Eigen::Isometry3d T = random_motion(random, 0.2);
    tracks.move(T);
    T_now_first = T * T_now_first;
    for (const auto& [track, estimate] : tracks) {
      const SemanticNode<> fused = track.fused(options.correlation);
      CHECK(estimate.position->isApprox(*fused.position, 1e-9));
      CHECK(estimate.covariance.isApprox(fused.covariance, 1e-9));
      CHECK(estimate.label == fused.label);
      CHECK(estimate.size == fused.size);
    }
  }
}
