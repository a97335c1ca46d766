// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/edges/knn_edges.hpp>
#include <topobag/recognition/explain.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

/// A room that stands in the world as often as it is said, 20 m apart, seen anew at each place from
/// so many spots near one another.
Relocalizer<> equal_rooms(const SyntheticRoom& room, std::size_t rooms, std::size_t spots,
                          std::mt19937& random) {
  Relocalizer<> relocalizer;
  std::normal_distribution<double> step(0.0, 0.1);
  for (std::uint64_t id = 0; id < rooms * spots; ++id) {
    Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
    camera.translation() = Eigen::Vector3d(step(random), step(random), step(random));
    EntryInfo info;
    info.T_world_camera =
        Eigen::Translation3d(20.0 * static_cast<double>(id / spots), 0.0, 0.0) * camera;
    relocalizer.map().add(KeyframeId{id}, room.seen_from(camera), info);
  }
  return relocalizer;
}

const CandidateReport& report_of(const Recognition& recognition, KeyframeId id) {
  return *std::find_if(recognition.candidates.begin(), recognition.candidates.end(),
                       [&](const CandidateReport& report) { return report.id == id; });
}

}  // namespace

TEST_CASE("where nothing is accepted, nothing is verified", "[recognition]") {
  std::mt19937 random(11);
  std::size_t shared = 0, judged_elsewhere = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::size_t spots = 1 + seed % 5;
    const SyntheticRoom room(seed, 9, 5);
    // More rooms than places are judged, too.
    const Relocalizer<> lost = equal_rooms(room, 2 + seed % 6, spots, random);
    const Recognition recognition = lost.localize(room.seen_from(Eigen::Isometry3d::Identity()));
    CHECK_FALSE(recognition);
    for (const CandidateReport& report : recognition.candidates) {
      INFO("room " << seed << ", key frame " << value(report.id));
      CHECK_FALSE(is_verified(report.verdict));
      CHECK((report.verdict == Verdict::rivalled) == report.rival.has_value());
      if (!report.judged_by) continue;
      ++shared;
      const CandidateReport& better = report_of(recognition, *report.judged_by);
      CHECK_FALSE(report.place_support);
      CHECK(report.pose->score() <= better.pose->score());
      CHECK(report.verdict == Verdict::rivalled);
      judged_elsewhere += value(report.id) / spots != value(better.id) / spots ? 1U : 0U;
    }
  }
  CHECK(shared > 50);
  CHECK(judged_elsewhere > 5);
}

TEST_CASE("a place that was not judged is not verified beside a better one elsewhere",
          "[recognition]") {
  std::mt19937 random(13);
  std::size_t elsewhere = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const SyntheticRoom room(seed, 9, 6);
    Relocalizer<> lost = equal_rooms(room, 1, 3, random);
    const TopologyGraph<> query = room.seen_from(Eigen::Isometry3d::Identity());
    for (std::uint64_t place = 1; place <= 12; ++place) {  // six of its objects stand there alike
      std::vector<SemanticNode<>> some(query.nodes().begin(), query.nodes().begin() + 6);
      EntryInfo info;
      info.T_world_camera = Eigen::Translation3d(0.0, 20.0 * static_cast<double>(place), 0.0) *
                            Eigen::Isometry3d::Identity();
      lost.map().add(KeyframeId{100 + place}, make_topology_graph(std::move(some), KnnEdges{}),
                     info);
    }
    for (const CandidateReport& report : lost.localize(query).candidates) {
      if (value(report.id) < 100) continue;
      CHECK_FALSE(is_verified(report.verdict));
      if (!report.judged_by) continue;
      ++elsewhere;
      CHECK(report.verdict == Verdict::rivalled);
      CHECK(report.rival->id == *report.judged_by);
    }
  }
  CHECK(elsewhere > 20);
}

TEST_CASE("what is of an accepted one's place is verified with it, and says by which",
          "[recognition]") {
  std::mt19937 random(12);
  std::size_t shared = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const SyntheticRoom room(seed, 9, 6);
    const Relocalizer<> lost = equal_rooms(room, 1, 5, random);
    const TopologyGraph<> query = room.seen_from(Eigen::Isometry3d::Identity());
    const Recognition recognition = lost.localize(query);
    REQUIRE(recognition);
    for (const CandidateReport& report : recognition.candidates) {
      if (!report.judged_by) continue;
      ++shared;
      CHECK(report.verdict == Verdict::not_best);
      CHECK(*report.judged_by == recognition.accepted->id);
      const auto explained = explain_candidate(report, *lost.map().find(report.id), query,
                                               ClassCatalog::coco80(), lost.options());
      REQUIRE(explained.failed());
      CHECK(explained.failed()->name == "first of its place, which is judged for all");
    }
  }
  CHECK(shared > 20);
}
