// SPDX-License-Identifier: MIT
// What does a key frame cost a SLAM front end, detector aside?
//
// A table's key frames, every 0.4 s, go through what the topology thread and loop closing do with
// each: lift its detections, fuse them with those of the last 3 s, look the graph up among the key
// frames so far and verify the candidates, add it. A second sequence of the same place is then
// looked up in that map, as a lost tracker does. The whole is repeated; each key frame counts with
// its median. Describing an object's colours stands by itself: boxes of 100 × 100 px all over a
// made-up image of 640 × 480, with depth and without. Tables are files of the `topobag` program:
// MAP and QUERY, by default those of examples/data; CANDIDATES, by default as many as
// `OrbSlamOptions` has, are verified for each query; detections below MIN_CONFIDENCE are left out.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/error.hpp>
#include <topobag/graph/local_graph.hpp>
#include <topobag/graph/sight_keyframe.hpp>
#include <topobag/recognition/relocalizer.hpp>
#include <topobag/sensing/color_descriptor.hpp>
#include <topobag/sensing/depth_view.hpp>
#include <topobag/sensing/image_view.hpp>

#include "node_table.hpp"
#include "pair_times.hpp"

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

void report_color(const char* what, const std::vector<double>& times) {
  const double median = bench::share(times, 0.5), most = bench::share(times, 0.95);
  std::printf("%-28s %8zu times %8.2f us, %8.2f in 95 %%\n", what, times.size(), median, most);
  std::printf(
      "{\"bench\":\"frontend\",\"what\":\"%s\",\"times\":%zu,\"median_us\":%.3f,\"p95_us\":%.3f}\n",
      what, times.size(), median, most);
}

/// A box's colour descriptor, the least of three times for each of 1,000 boxes, and an image's mean
/// colour, which comes once. False when a box was not described.
bool bench_color() {
  constexpr int width = 640, height = 480;
  std::mt19937 random(1);
  std::vector<std::uint8_t> colors(std::size_t{3} * width * height);
  std::vector<std::uint16_t> depths(std::size_t{width} * height);
  for (std::uint8_t& color : colors) color = static_cast<std::uint8_t>(random());
  for (std::uint16_t& depth : depths) depth = static_cast<std::uint16_t>(1800 + random() % 400);
  const ImageView image(colors.data(), width, height, ColorOrder::bgr);
  const DepthView<std::uint16_t> depth(depths.data(), width, height, 1000.0);
  std::vector<double> means, plain, ranged;
  bool all_known = true;
  const ColorDescriptor describe(image);
  std::uniform_real_distribution<double> left(0.0, width - 100.0), top(0.0, height - 100.0);
  for (int i = 0; i < 1000; ++i) {
    const double x = left(random), y = top(random);
    const BoundingBox box{x, y, x + 100.0, y + 100.0};
    means.push_back(bench::least_time([&] {
      all_known = ColorDescriptor(image)(BoundingBox{0, 0, 1, 1}).known() && all_known;
    }));
    plain.push_back(bench::least_time([&] { all_known = describe(box).known() && all_known; }));
    ranged.push_back(
        bench::least_time([&] { all_known = describe(box, depth, 2.0).known() && all_known; }));
  }
  report_color("mean colour of an image", means);
  report_color("colours of a box", plain);
  report_color("colours of a box, depth", ranged);
  return all_known;
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
    if (!bench_color()) {
      std::fprintf(stderr, "a box was not described\n");
      return 1;
    }
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
