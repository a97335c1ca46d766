// SPDX-License-Identifier: MIT
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/adaptors/topology_thread.hpp>

#include "adaptors/small_host.hpp"
#include "catch.hpp"
#include "long_rounds.hpp"

using namespace topobag;

namespace {

struct RacingMap {
  std::atomic<bool> bad{false};
  std::mutex mMutexMapUpdate;

  bool IsBad() const { return bad; }
};

/// As an ORB-SLAM3's: it moves, changes its map and is culled meanwhile.
struct RacingKeyFrame {
  RacingKeyFrame(unsigned long id, double stamp, const Eigen::Isometry3d& T, RacingMap& in)
      : mnId(id), mTimeStamp(stamp), inner(id, stamp, T), map(&in) {}

  const unsigned long mnId;
  const double mTimeStamp;
  small_host::KeyFrame inner;
  std::atomic<RacingMap*> map;

  bool isBad() const { return inner.isBad(); }
  RacingMap* GetMap() const { return map; }
  small_host::Pose GetPoseInverse() const { return inner.GetPoseInverse(); }
  std::set<RacingKeyFrame*> GetConnectedKeyFrames() const { return {}; }
};

using RacingDatabase = OrbSlamDatabase<RacingKeyFrame, small_host::Frame, RacingMap>;

/// Two maps: tracking makes key frames in one of them and is lost under its lock, loop closing asks
/// for loops and merges, moves poses and merges under the maps' locks, culls; now and then a map is
/// given up and its key frames deleted. The topology thread looks after the graphs.
void race_of_maps(std::chrono::milliseconds duration) {
  const SyntheticRoom room(7, 9, 4);
  OrbSlamOptions options;
  options.loop_wait = std::chrono::milliseconds(0);
  RacingDatabase database(options, [&](const small_host::Frame& frame) {
    return std::optional<TopologyGraph<>>(room.seen_from(frame.T_world_camera));
  });
  struct Job {
    std::uint64_t epoch, id;
    KeyframeSighting seen;
  };
  TopologyThread<Job> topology([&](const Job& job) {
    database.refresh_changed();
    database.observe(job.epoch, job.id, job.seen);
  });
  std::array<RacingMap, 2> maps;
  std::mutex host_mutex;  // of the key frames; loop closing holds it while it works
  std::vector<std::unique_ptr<RacingKeyFrame>> key_frames;
  std::size_t next_for_loop = 0;
  std::atomic<bool> finished{false};
  std::atomic<std::size_t> found{0};

  std::thread loop_closing([&] {
    std::mt19937 random(1);
    while (!finished) {
      const std::lock_guard<std::mutex> lock(host_mutex);
      if (next_for_loop >= key_frames.size()) continue;
      RacingKeyFrame* const current = key_frames[next_for_loop++].get();
      std::vector<RacingKeyFrame*> loops, merges;
      database.DetectNBestCandidates(current, loops, merges, 3);
      found += loops.size() + merges.size();
      database.add(current);
      const std::lock_guard<std::mutex> first(maps[0].mMutexMapUpdate);
      const std::lock_guard<std::mutex> second(maps[1].mMutexMapUpdate);
      current->inner.SetPoseInverse(random_camera(random));
      if (random() % 10 == 0) current->map = &maps[random() % 2];
      if (random() % 5 == 0) {  // as an IMU's initialisation does: under the lock
        RacingKeyFrame* const culled = key_frames[random() % key_frames.size()].get();
        culled->inner.SetBadFlag();
        database.erase(culled);
      }
    }
  });
  std::thread tracking([&] {
    std::mt19937 random(2);
    double stamp = 0.0;
    for (unsigned long id = 1; !finished; ++id, stamp += 0.5) {
      RacingMap& map = maps[random() % 2];
      const Eigen::Isometry3d T_world_camera = random_camera(random);
      {
        const std::lock_guard<std::mutex> lock(host_mutex);
        key_frames.push_back(std::make_unique<RacingKeyFrame>(id, stamp, T_world_camera, map));
      }
      topology.push({database.epoch(), id, small_host::sighting(room, stamp, T_world_camera)});
      {
        const std::lock_guard<std::mutex> lock(map.mMutexMapUpdate);
        small_host::Frame frame{stamp, random_camera(random)};
        found += database.DetectRelocalizationCandidates(&frame, &map).size();
      }
      if (random() % 25 != 0) continue;
      const std::lock_guard<std::mutex> lock(host_mutex);
      database.clearMap(&map);
      std::vector<std::unique_ptr<RacingKeyFrame>> kept;
      for (std::size_t i = 0; i < next_for_loop; ++i) {
        if (key_frames[i]->map != &map) kept.push_back(std::move(key_frames[i]));
      }
      key_frames = std::move(kept);
      next_for_loop = key_frames.size();
    }
  });
  std::this_thread::sleep_for(duration);
  finished = true;
  loop_closing.join();
  tracking.join();
  topology.wait_idle();
  CHECK_FALSE(database.sightings().empty());
  database.clear();
  CHECK(found > 0);
  CHECK(database.failures().first == 0);
}

}  // namespace

TEST_CASE("key frames are moved, merged, given up and deleted while they are queried",
          "[adaptors]") {
  race_of_maps(std::chrono::milliseconds(500));
}

TEST_CASE("several maps for half a minute", "[adaptors][long]") {
  race_of_maps(std::chrono::milliseconds(long_rounds(30000)));
}
