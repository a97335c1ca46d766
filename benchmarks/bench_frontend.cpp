// SPDX-License-Identifier: MIT
// What does a key frame cost a SLAM front end, detector aside?
//
// A table's key frames, every 0.4 s, go through what the topology thread and loop closing do with
// each: lift its detections, fuse them with those of the last 3 s, look the graph up among the key
// frames so far and verify the candidates, add it. A second sequence of the same place is then
// looked up in that map, as a lost tracker does. The whole is repeated; each key frame counts with
// its median. Tables are files of the `topobag` program: MAP and QUERY, by default those of
// examples/data; CANDIDATES, by default as many as `OrbSlamOptions` has, are verified for each
// query; detections below MIN_CONFIDENCE are left out.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/local_graph.hpp>
#include <topobag/graph/sight_keyframe.hpp>
#include <topobag/recognition/relocalizer.hpp>

#include "node_table.hpp"

namespace {

using namespace topobag;
using Clock = std::chrono::steady_clock;

/// Microseconds of each stage of one key frame.
struct Cost {
  double lift = 0.0, fuse = 0.0, find = 0.0, add = 0.0;
  double total() const { return lift + fuse + find + add; }
};

double since(Clock::time_point& start) {
  const auto now = Clock::now();
  const double us = std::chrono::duration<double, std::micro>(now - start).count();
  start = now;
  return us;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Runs a table through the stages; with `grow`, its key frames stay in the map.
std::vector<Cost> run(const program::NodeTable& table, const PinholeCamera<>& camera,
                      const ClassCatalog& catalog, const SightingOptions& sighting,
                      Relocalizer<>& map, bool grow, std::size_t& accepted) {
  LocalGraph<> window;
  std::vector<Cost> costs;
  std::optional<Eigen::Isometry3d> T_world_previous;
  double due = table.frames.front().timestamp;
  for (const program::FrameRow& frame : table.frames) {
    if (frame.timestamp < due || !frame.T_world_camera) continue;
    due += 0.4 * (std::floor((frame.timestamp - due) / 0.4) + 1.0);
    Cost cost;
    auto clock = Clock::now();
    KeyframeSighting seen =
        sight_keyframe(frame.timestamp, frame.detections, camera, catalog, sighting);
    cost.lift = since(clock);
    const Eigen::Isometry3d T_previous_current =
        T_world_previous.value_or(*frame.T_world_camera).inverse() * *frame.T_world_camera;
    window.add(frame.timestamp, seen.nodes, T_previous_current, std::move(seen.view));
    TopologyGraph<> graph = window.graph();
    cost.fuse = since(clock);
    if (map.localize(graph)) ++accepted;
    cost.find = since(clock);
    if (grow && graph.is_matchable()) map.map().add(KeyframeId{costs.size()}, std::move(graph));
    cost.add = since(clock);
    costs.push_back(cost);
    T_world_previous = frame.T_world_camera;
  }
  return costs;
}

void report(const char* what, const std::vector<std::vector<Cost>>& runs, std::size_t map_size,
            std::size_t accepted) {
  const auto medians = [&](auto part) {
    std::vector<double> of_key_frames;
    for (std::size_t i = 0; i < runs.front().size(); ++i) {
      std::vector<double> repeated;
      for (const auto& costs : runs) repeated.push_back(part(costs[i]));
      of_key_frames.push_back(quantile(std::move(repeated), 0.5));
    }
    return of_key_frames;
  };
  const auto total = medians([](const Cost& c) { return c.total(); });
  const double lift = quantile(medians([](const Cost& c) { return c.lift; }), 0.5);
  const double fuse = quantile(medians([](const Cost& c) { return c.fuse; }), 0.5);
  const double find = quantile(medians([](const Cost& c) { return c.find; }), 0.5);
  const double add = quantile(medians([](const Cost& c) { return c.add; }), 0.5);
  std::printf("%-10s %10zu %8zu %8.1f %8.1f %8.1f %8.1f %9.1f %9.1f\n", what, total.size(),
              map_size, lift, fuse, find, add, quantile(total, 0.5), quantile(total, 0.95));
  std::printf(
      "{\"bench\":\"frontend\",\"what\":\"%s\",\"key_frames\":%zu,\"map\":%zu,\"accepted\":%zu,"
      "\"lift_us\":%.1f,\"fuse_us\":%.1f,\"find_us\":%.1f,\"add_us\":%.1f,\"median_us\":%.1f,"
      "\"p95_us\":%.1f}\n",
      what, total.size(), map_size, accepted, lift, fuse, find, add, quantile(total, 0.5),
      quantile(total, 0.95));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string data = std::string(TOPOBAG_SOURCES) + "/examples/data/";
  const std::string map_set = argc > 2 ? argv[1] : data + "fr1_xyz";
  const std::string query_set = argc > 2 ? argv[2] : data + "fr1_rpy";
  RecognitionOptions recognition = OrbSlamOptions{}.recognition;
  if (argc > 3) recognition.retrieval.max_results = static_cast<std::size_t>(std::atoi(argv[3]));
  SightingOptions sighting;
  if (argc > 4) sighting.lifting.min_confidence = std::atof(argv[4]);
  const PinholeCamera<> camera{517.3, 516.5, 318.6, 255.3, 640, 480};
  const ClassCatalog catalog = ClassCatalog::coco80();
  try {
    const program::NodeTable map_table = program::read_node_table(map_set);
    const program::NodeTable query_table = program::read_node_table(query_set);
    constexpr std::size_t repeats = 7;
    std::vector<std::vector<Cost>> growing, lost;
    std::size_t loops = 0, found = 0, size = 0;
    for (std::size_t i = 0; i < repeats; ++i) {
      Relocalizer<> map(recognition);
      loops = found = 0;
      growing.push_back(run(map_table, camera, catalog, sighting, map, true, loops));
      lost.push_back(run(query_table, camera, catalog, sighting, map, false, found));
      size = map.map().size();
    }
    std::printf("%-10s %10s %8s %8s %8s %8s %8s %9s %9s\n", "", "key frames", "map", "lift, us",
                "fuse", "find", "add", "all", "95 %");
    report("mapping", growing, size, loops);
    report("lost", lost, size, found);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
