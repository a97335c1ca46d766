// SPDX-License-Identifier: MIT
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/adaptors/topology_thread.hpp>

#include "adaptors/small_database.hpp"
#include "adaptors/small_host.hpp"
#include "catch.hpp"
#include "long_rounds.hpp"

using namespace topobag;
using namespace small_host;

namespace {

/// A host at work: tracking makes key frames, now and then is lost, now and then resets and
/// deletes all of them; loop closing queries, adds and culls; the topology thread works beside.
void race(std::chrono::milliseconds duration) {
  const SyntheticRoom room(7, 9, 4);
  Database database(without_waiting(), [&](const Frame& frame) {
    return std::optional<TopologyGraph<>>(room.seen_from(frame.T_world_camera));
  });
  struct Job {
    std::uint64_t epoch, id;
    KeyframeSighting seen;
  };
  TopologyThread<Job> topology([&](const Job& job) {
    if (job.id % 7 == 3) throw std::runtime_error("the detector failed");
    database.observe(job.epoch, job.id, job.seen);
  });

  std::mutex host_mutex;  // of the queue; loop closing holds it while it works, as a reset waits
  std::vector<std::unique_ptr<KeyFrame>> key_frames;
  std::size_t next_for_loop = 0;
  std::atomic<bool> finished{false};
  std::atomic<std::size_t> found{0};

  std::thread loop_closing([&] {
    std::mt19937 random(1);
    while (!finished) {
      const std::lock_guard<std::mutex> lock(host_mutex);
      if (next_for_loop == key_frames.size()) continue;
      KeyFrame* const current = key_frames[next_for_loop++].get();
      found += database.DetectLoopCandidates(current, 0.0F).size();
      database.add(current);
      if (random() % 3 == 0) {
        KeyFrame* const culled = key_frames[random() % key_frames.size()].get();
        culled->SetBadFlag();
        database.erase(culled);
      }
      if (random() % 20 == 0) database.refresh();
      if (random() % 10 == 0) {
        RecognitionOptions options = database.options();
        options.retrieval.max_results = 2 + random() % 3;
        database.set_options(options);
        CHECK(database.copy_of().map().size() <= database.size());  // it alone adds
      }
      current->SetPoseInverse(random_camera(random));
    }
  });
  std::thread tracking([&] {
    std::mt19937 random(2);
    unsigned long id = 0;
    double stamp = 0.0;
    while (!finished) {
      const Eigen::Isometry3d T_world_camera = random_camera(random);
      {
        const std::lock_guard<std::mutex> lock(host_mutex);
        key_frames.push_back(std::make_unique<KeyFrame>(id, stamp, T_world_camera));
        if (id > 0) key_frames.back()->AddConnection(key_frames[id - 1].get());
      }
      topology.push({database.epoch(), id, sighting(room, stamp, T_world_camera)});
      ++id;
      stamp += 0.5;
      Frame frame{stamp, random_camera(random)};
      found += database.DetectRelocalizationCandidates(&frame).size();
      if (random() % 25 == 0) {  // the topology thread is not told: the database has to cope
        const std::lock_guard<std::mutex> lock(host_mutex);
        database.clear();
        key_frames.clear();
        next_for_loop = 0;
        id = 0;
      }
    }
  });
  std::this_thread::sleep_for(duration);
  finished = true;
  loop_closing.join();
  tracking.join();
  topology.wait_idle();
  database.clear();
  CHECK(found > 0);
  CHECK(database.failures().first == 0);
  const TopologyThreadCounts counts = topology.counts();
  CHECK(counts.pushed == counts.processed + counts.failed + counts.given_up);
}

}  // namespace

TEST_CASE("key frames are culled, reset and deleted while they are queried", "[adaptors]") {
  race(std::chrono::milliseconds(500));
}

TEST_CASE("the same for half a minute", "[adaptors][long]") {
  race(std::chrono::milliseconds(long_rounds(30000)));
}
