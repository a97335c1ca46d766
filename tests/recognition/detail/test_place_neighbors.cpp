// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/recognition/detail/place_hypotheses.hpp>
#include <topobag/recognition/detail/place_neighbors.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

/// A camera a few centimetres and degrees away, as in the next images of a film.
Eigen::Isometry3d soon_after(const Eigen::Isometry3d& camera, std::mt19937& random) {
  std::uniform_real_distribution<double> small(-0.03, 0.03);
  const double x = small(random), y = small(random), turn = small(random);
  return camera * Eigen::Translation3d(x, y, 0.0) *
         Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY());
}

struct FilmedRoom {
  BagOfTopologyGraphs<> bag;
  std::vector<Eigen::Isometry3d> cameras;
};

/// Every stop of the camera is in the map `images` times.
FilmedRoom filmed(std::mt19937& random, std::size_t stops, std::size_t images) {
  FilmedRoom filmed;
  const SyntheticRoom room(7, 10, 10);
  for (std::size_t stop = 0; stop < stops; ++stop) {
    const Eigen::Isometry3d camera = random_camera(random);
    for (std::size_t image = 0; image < images; ++image) {
      filmed.cameras.push_back(image == 0 ? camera : soon_after(camera, random));
      filmed.bag.add(KeyframeId{filmed.cameras.size() - 1}, room.seen_from(filmed.cameras.back()),
                     standing_at(filmed.cameras.back()));
    }
  }
  return filmed;
}

}  // namespace

TEST_CASE("neighbours are the nearest, each so far from all before", "[recognition]") {
  std::mt19937 random(3);
  const TopologyGraph<> query = SyntheticRoom(7, 10, 10).seen_from(random_camera(random));
  for (int round = 0; round < 30; ++round) {
    const FilmedRoom film = filmed(random, 1 + random() % 8, 1 + random() % 6);
    PlaceOptions options;
    options.max_keyframes = random() % 6;
    options.spacing = 0.05 * static_cast<double>(random() % 6);
    const std::size_t of = random() % film.cameras.size();
    const Eigen::Isometry3d query_camera = random_camera(random);
    const Eigen::Isometry3d T_candidate_query = film.cameras[of].inverse() * query_camera;
    const auto distance = [&](const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
      return detail::camera_distance(a, b, options);
    };

    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < film.cameras.size(); ++i) {
      if (i != of) order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return distance(query_camera, film.cameras[a]) < distance(query_camera, film.cameras[b]);
    });
    std::vector<Eigen::Isometry3d> expected{film.cameras[of]};
    for (const std::size_t i : order) {
      if (expected.size() > options.max_keyframes) break;
      const bool far = std::all_of(expected.begin(), expected.end(), [&](const auto& other) {
        return distance(other, film.cameras[i]) >= options.spacing;
      });
      if (far) expected.push_back(film.cameras[i]);
    }

    const auto found =
        detail::neighbors_by_pose(film.bag, KeyframeId{of}, standing_at(film.cameras[of]),
                                  T_candidate_query, query, {}, options);
    REQUIRE(found.size() + 1 == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK((film.cameras[of] * found[i].T_candidate_neighbor).isApprox(expected[i + 1], 1e-9));
    }
    const auto repeats = std::count_if(order.begin(), order.end(), [&](std::size_t i) {
      return distance(film.cameras[of], film.cameras[i]) < options.spacing;
    });
    CHECK(detail::repeated_views(film.bag, KeyframeId{of}, standing_at(film.cameras[of]), query, {},
                                 options) == static_cast<std::size_t>(repeats));
  }
}

TEST_CASE("what another session saw from the same spot is no repetition", "[recognition]") {
  BagOfTopologyGraphs<> bag;
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  const TopologyGraph<> graph = SyntheticRoom(7, 10, 10).seen_from(here);
  for (unsigned i = 0; i < 3; ++i) bag.add(KeyframeId{i}, graph, standing_at(here, i));
  CHECK(detail::repeated_views(bag, KeyframeId{1}, standing_at(here, 1), graph, {}, {}) == 0);
  CHECK(detail::neighbors_by_pose(bag, KeyframeId{1}, standing_at(here, 1), here, graph, {}, {})
            .size() == 2);
}

TEST_CASE("without a pose no view is known to repeat", "[recognition]") {
  BagOfTopologyGraphs<> bag;
  const TopologyGraph<> graph = SyntheticRoom(7, 10, 10).seen_from(Eigen::Isometry3d::Identity());
  for (unsigned i = 0; i < 3; ++i) bag.add(KeyframeId{i}, graph);
  CHECK(detail::repeated_views(bag, KeyframeId{1}, {}, graph, {}, {}) == 0);
}

TEST_CASE("the more often a view is in the map, the less counts its luckiest image",
          "[recognition][regression]") {
  CHECK(detail::share_among_repeats(0) == 0.5);
  CHECK(detail::share_among_repeats(1) == 0.5);
  CHECK(detail::share_among_repeats(9) == 0.9);

  // All stops but the one that is matched lack half of the objects, and speak against it.
  const SyntheticRoom room(7, 8, 8);
  for (const std::size_t images : {1U, 4U, 40U}) {
    std::mt19937 random(5);
    Relocalizer<> relocalizer;
    const Eigen::Isometry3d matched = Eigen::Isometry3d::Identity();
    const TopologyGraph<> query = room.seen_from(matched);
    relocalizer.map().add(KeyframeId{0}, query, standing_at(matched));
    std::vector<SemanticNode<>> elsewhere(query.nodes());
    for (auto& node : elsewhere) node.position->x() += 0.5;
    for (std::size_t i = 1; i <= images; ++i) {
      relocalizer.map().add(KeyframeId{i}, TopologyGraph<>(elsewhere),
                            standing_at(soon_after(matched, random)));
    }
    const Recognition found = relocalizer.localize(query);
    const auto report =
        std::find_if(found.candidates.begin(), found.candidates.end(),
                     [](const CandidateReport& candidate) { return candidate.place_support; });
    REQUIRE(report != found.candidates.end());
    const bool speaks_against = *report->place_support < report->pose->support();
    const std::size_t counted = std::min(images, PlaceOptions{}.max_keyframes);
    CHECK(report->place_share == (speaks_against ? detail::share_among_repeats(counted) : 0.5));
    CHECK(report->support() == (1.0 - report->place_share) * report->pose->support() +
                                   report->place_share * *report->place_support);
  }
}
