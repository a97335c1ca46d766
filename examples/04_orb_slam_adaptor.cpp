// SPDX-License-Identifier: MIT
// The adaptor beside an ORB-SLAM, with the least a host has: key frames with an id, a pose and
// covisible neighbours. examples/orb_slam2 does the same with the real one.
#include <array>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/adaptors/topology_thread.hpp>

using namespace topobag;

// ---- The host: ORB-SLAM's names
// ------------------------------------------------------------------

namespace host {

/// 4 × 4 floats, read with at<float>(row, column) as a cv::Mat is.
struct Mat {
  std::array<float, 16> numbers;

  template <typename T>
  T at(int row, int column) const {
    return numbers[static_cast<std::size_t>(4 * row + column)];
  }
};

struct KeyFrame {
  unsigned long mnId;
  double mTimeStamp;
  Mat Twc;
  std::set<KeyFrame*> covisible;

  bool isBad() const { return false; }
  Mat GetPoseInverse() const { return Twc; }
  std::set<KeyFrame*> GetConnectedKeyFrames() const { return covisible; }
};

struct Frame {
  double mTimeStamp;
};

struct Map {};

}  // namespace host

// ---- A camera before a desk
// ----------------------------------------------------------------------

const PinholeCamera<> camera{525.0, 525.0, 319.5, 239.5, 640, 480};
const ClassCatalog catalog = ClassCatalog::coco80();

/// What a detector with depth sees from `x` metres to the right.
std::vector<RangedDetection> detect(double x) {
  struct Thing {
    const char* name;
    double x, y, z;  // m
  };
  std::vector<RangedDetection> found;
  for (const Thing& thing : {Thing{"tv", 0.0, -0.25, 2.0},
                             {"keyboard", 0.0, 0.3, 1.6},
                             {"mouse", 0.45, 0.3, 1.6},
                             {"cup", -0.6, 0.15, 1.8},
                             {"book", -0.75, -0.3, 2.1},
                             {"vase", 0.8, -0.3, 2.2}}) {
    const Eigen::Vector2d center = *camera.project({thing.x - x, thing.y, thing.z});
    const double side = camera.fx * 0.2 / thing.z;
    found.push_back({box_around(center, side, side), catalog.at(thing.name), 0.9, thing.z});
  }
  return found;
}

int main() {
  // What lost tracking asks for: the graph of the frame it holds. Here: half a metre to the right.
  const auto graph_of_frame = [](const host::Frame& frame) {
    auto seen = sight_keyframe(frame.mTimeStamp, detect(0.5), camera, catalog);
    return std::optional(make_topology_graph(std::move(seen.nodes), KnnEdges{}));
  };
  OrbSlamDatabase<host::KeyFrame, host::Frame, host::Map> database(orb_slam_options(catalog),
                                                                   graph_of_frame);

  // The topology thread: detect, lift, hand on. Its input owns what it needs.
  struct Job {
    std::uint64_t epoch, id;
    double stamp, x;
  };
  TopologyThread<Job> thread(
      [&](const Job& job) {
        database.observe(job.epoch, job.id,
                         sight_keyframe(job.stamp, detect(job.x), camera, catalog));
      },
      {}, [&](const Job& job, const std::string&) { database.give_up(job.epoch, job.id); });

  // Tracking makes key frames and hands them over; loop closing asks, then adds.
  std::vector<std::unique_ptr<host::KeyFrame>> map;
  std::size_t loops = 0;
  for (unsigned long id = 0; id < 6; ++id) {
    const float x = id < 3 ? 0.1F * static_cast<float>(id) : 0.1F * static_cast<float>(5 - id);
    host::Mat Twc{{1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    map.push_back(std::make_unique<host::KeyFrame>(
        host::KeyFrame{id, 10.0 * static_cast<double>(id), Twc, {}}));
    if (id > 0) map[id]->covisible = {map[id - 1].get()};
    thread.push({database.epoch(), id, map[id]->mTimeStamp, static_cast<double>(x)});
    loops += database.DetectLoopCandidates(map[id].get(), 0.0F).size();
    database.add(map[id].get());
  }
  std::cout << database.size() << " key frames in the bag, " << loops << " loop candidates\n";

  // Lost: candidates for the host's BoW and PnP, and a pose to begin with.
  const host::Frame lost{100.0};
  const auto places = database.relocalization_places(lost);
  if (places.empty() || !places.front().verified || loops == 0) return EXIT_FAILURE;
  const Eigen::Vector3d found = places.front().T_world_query.translation();
  std::cout << "lost camera found at " << found.transpose() << " m\n";

  // Before a reset or the end: ours stops first; after `clear` no key frame is touched again.
  thread.stop();
  database.clear();
  return (found - Eigen::Vector3d(0.5, 0.0, 0.0)).norm() < 0.02 ? EXIT_SUCCESS : EXIT_FAILURE;
}
