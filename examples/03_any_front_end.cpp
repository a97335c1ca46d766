// SPDX-License-Identifier: MIT
// A whole front end: any detector and any depth sensor, each a callable; odometry; a window of
// key frames fused into one graph; loops found while the map grows. Nothing but the library.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <vector>

#include <topobag/graph/local_graph.hpp>
#include <topobag/graph/sight_keyframe.hpp>
#include <topobag/recognition/loop_detector.hpp>
#include <topobag/sensing/dynamic_feature_mask.hpp>
#include <topobag/sensing/range_detections.hpp>

using namespace topobag;

namespace {

const PinholeCamera<> camera{525.0, 525.0, 319.5, 239.5, 640, 480};
const ClassCatalog catalog = ClassCatalog::coco80();

/// Stands in for the world before the camera: things on a desk, and someone who walks past.
struct Thing {
  const char* name;
  Eigen::Vector3d position;  // m
  double width, height;      // m
};
std::vector<Thing> things_at(double stamp) {
  return {{"tv", {0.0, -0.25, 2.0}, 0.5, 0.3},
          {"keyboard", {0.0, 0.3, 1.6}, 0.4, 0.1},
          {"mouse", {0.45, 0.3, 1.6}, 0.08, 0.06},
          {"cup", {-0.6, 0.15, 1.8}, 0.1, 0.12},
          {"book", {-0.75, -0.3, 2.1}, 0.25, 0.3},
          {"potted plant", {0.8, -0.3, 2.2}, 0.3, 0.4},
          {"person", {std::fmod(0.3 * stamp, 2.0) - 1.0, 0.0, 3.0}, 0.4, 0.8}};
}

/// The detector: an image in, boxes out. Here the "image" is a stamp and the pose it was taken
/// from; every third image it misses one thing, as detectors do.
std::vector<Detection> detect(int image, double stamp, const Eigen::Isometry3d& T_world_camera) {
  std::vector<Detection> found;
  const std::vector<Thing> things = things_at(stamp);
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (image % 3 == 0 && i == static_cast<std::size_t>(image) % 6) continue;
    const Eigen::Vector3d p = T_world_camera.inverse() * things[i].position;
    found.push_back({box_around(*camera.project(p), camera.fx * things[i].width / p.z(),
                                camera.fy * things[i].height / p.z()),
                     catalog.at(things[i].name), 0.8});
  }
  return found;
}

/// The depth sensor: a pixel in, metres or nothing out. The nearest thing there, or the wall.
std::optional<double> depth_at(const Eigen::Vector2d& pixel, double stamp,
                               const Eigen::Isometry3d& T_world_camera) {
  std::optional<double> nearest = 5.0;
  for (const Thing& thing : things_at(stamp)) {
    const Eigen::Vector3d p = T_world_camera.inverse() * thing.position;
    const BoundingBox box = box_around(*camera.project(p), camera.fx * thing.width / p.z(),
                                       camera.fy * thing.height / p.z());
    if (box.contains(pixel) && p.z() < *nearest) nearest = p.z();
  }
  return nearest;
}

}  // namespace

int main() {
  LocalGraph<> window;  // the last 3 s
  // A loop is at least 20 s old.
  LoopDetector<> loops(LoopOptions{20.0, recognition_options(catalog)});
  std::optional<Eigen::Isometry3d> T_world_previous;
  std::size_t masked = 0, found = 0;

  for (int image = 0; image < 60; ++image) {
    const double stamp = 0.5 * image;
    // Odometry: there and back. Only relative poses are used below.
    const double along = image < 30 ? 0.02 * image : 0.02 * (60 - image);
    const Eigen::Isometry3d T_world_camera(Eigen::Translation3d(along, 0.0, -0.5 * along));

    // 1. Detector and depth meet: every box gets its distance.
    const auto depth = [&](const Eigen::Vector2d& pixel) {
      return depth_at(pixel, stamp, T_world_camera);
    };
    const auto detections = range_detections(detect(image, stamp, T_world_camera), depth, camera);

    // 2. Features on people are not to be tracked; the wall seen beside them is.
    const DynamicFeatureMask mask(detections, catalog);
    for (double u = 20.0; u < 640.0; u += 40.0) masked += mask({u, 240.0}, depth({u, 240.0}));

    // 3. The key frame's objects join those of the last seconds; how far it sees comes along.
    const KeyframeSighting seen = sight_keyframe(stamp, detections, depth, camera, catalog);
    const Eigen::Isometry3d T_previous_current = T_world_previous
                                                     ? T_world_previous->inverse() * T_world_camera
                                                     : Eigen::Isometry3d::Identity();
    window.add(seen, T_previous_current);
    T_world_previous = T_world_camera;

    // 4. Has it been here? The answer carries the relative pose.
    const auto id = KeyframeId{static_cast<std::uint64_t>(image)};
    const Recognition loop = loops.detect_and_add(id, stamp, window.graph());
    if (!loop) continue;
    ++found;
    const double back = 0.02 * static_cast<double>(value(loop.accepted->id));
    const Eigen::Vector3d expected(along - back, 0.0, -0.5 * (along - back));
    const double error = (loop.accepted->pose->T_candidate_query.translation() - expected).norm();
    std::cout << "image " << image << ": loop to " << value(loop.accepted->id) << ", off by "
              << error << " m\n";
    if (error > 0.05) return EXIT_FAILURE;
  }
  std::cout << found << " loops, " << masked << " features on people masked\n";
  return found > 0 && masked > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
