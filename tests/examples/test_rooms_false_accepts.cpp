// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "long_rounds.hpp"
#include "look_up_places.hpp"
#include "recombined_graphs.hpp"

using namespace topobag;

namespace {

/// The key frames of rooms that a table visits one after another, 200 m apart.
std::vector<std::vector<program::Keyframe>> by_room(std::vector<program::Keyframe> keyframes) {
  std::vector<std::vector<program::Keyframe>> rooms;
  Eigen::Vector3d last(1e9, 0.0, 0.0);
  for (program::Keyframe& keyframe : keyframes) {
    const Eigen::Vector3d at = keyframe.T_world_camera->translation();
    if ((at - last).norm() > 100.0) rooms.emplace_back();
    last = at;
    rooms.back().push_back(std::move(keyframe));
  }
  return rooms;
}

/// A map that grows, and what queries of places that it does not hold came to.
class GrowingMap {
 public:
  explicit GrowingMap(std::vector<TopologyGraph<>> queries)
      : relocalizer_(default_of(accept_any_score())), queries_(std::move(queries)) {}

  void add(const TopologyGraph<>& graph, const Eigen::Isometry3d& T_world_camera) {
    if (!graph.is_matchable()) return;
    EntryInfo info;
    info.T_world_camera = T_world_camera;
    relocalizer_.map().add(KeyframeId{relocalizer_.map().size()}, graph, info);
  }

  /// Queries that are accepted, of `queries()`.
  std::size_t false_accepts() const {
    std::size_t accepted = 0;
    for (const auto& query : queries_) accepted += relocalizer_.localize(query) ? 1U : 0U;
    return accepted;
  }

  std::size_t queries() const { return queries_.size(); }
  std::size_t keyframes() const { return relocalizer_.map().size(); }
  std::size_t places() const { return relocalizer_.map().places(); }

 private:
  static RecognitionOptions default_of(RecognitionOptions options) {
    options.decision = {};
    return options;
  }

  Relocalizer<> relocalizer_;
  std::vector<TopologyGraph<>> queries_;
};

/// So many of them, evenly spread.
std::vector<TopologyGraph<>> some_graphs(const std::vector<program::Keyframe>& keyframes,
                                         std::size_t wanted) {
  std::vector<TopologyGraph<>> usable, some;
  for (const auto& keyframe : keyframes) {
    if (keyframe.graph.is_matchable()) usable.push_back(keyframe.graph);
  }
  const std::size_t count = std::min(wanted, usable.size());
  for (std::size_t i = 0; i < count; ++i) some.push_back(usable[i * usable.size() / count]);
  return some;
}

}  // namespace

TEST_CASE("the rate of false accepts is at most 1 in 300 queries, however large the map",
          "[examples][long]") {
  const char* const data = std::getenv("TOPOBAG_DATA");
  if (data == nullptr) {
    std::cout << "Skips the rooms: TOPOBAG_DATA is not set.\n";
    return;
  }
  std::size_t records = 0;
  std::vector<std::size_t> accepted(4);
  for (const double window : {0.0, 3.0}) {
    PlaceRun run;
    run.kind = PlaceKind::other;
    run.map = std::string(data) + "/rooms/other_map";
    run.query = std::string(data) + "/rooms/query";
    run.map_camera = run.query_camera = {525.0, 525.0, 319.5, 239.5, 640, 480};
    run.window = window;
    run.interval = 0.0;
    const auto rooms = by_room(keyframes_of(run, true));
    REQUIRE(rooms.size() == 84);
    GrowingMap map(some_graphs(keyframes_of(run, false), long_rounds(600)));
    records += map.queries();
    const auto measure = [&](std::size_t stage, const char* what) {
      const std::size_t here = map.false_accepts();
      accepted[stage] += here;
      std::cout << what << ", " << window << " s, " << map.keyframes() << " key frames at "
                << map.places() << " places: " << here << " of " << map.queries() << " accepted\n";
    };
    std::vector<TopologyGraph<>> pieces;
    std::size_t added = 0;
    const auto add_rooms = [&](std::size_t count) {
      for (; added < count; ++added) {
        for (const auto& keyframe : rooms[added]) {
          map.add(keyframe.graph, *keyframe.T_world_camera);
          pieces.push_back(keyframe.graph);
        }
      }
    };
    add_rooms(10);
    measure(0, "10 rooms");
    add_rooms(30);
    measure(1, "30 rooms");
    add_rooms(84);
    measure(2, "84 rooms");
    // Made-up places out of the rooms' pieces, far away and 20 m apart.
    RecombinedGraphs source(std::move(pieces), 5);
    const std::size_t places = long_rounds(12500);
    for (std::size_t place = 0; place < places; ++place) {
      const auto nodes = source.place();
      const Eigen::Isometry3d at(
          Eigen::Translation3d(20.0 * static_cast<double>(place), -1e6, 0.0));
      for (int visit = 0; visit < 4; ++visit) map.add(source.keyframe(nodes), at);
    }
    measure(3, "and made-up places");
  }
  for (const std::size_t stage : accepted) CHECK(300 * stage <= records);
}
