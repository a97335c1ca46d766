// SPDX-License-Identifier: MIT
// What does it cost when a loop was closed and all poses change, and what as a run beside an
// ORB-SLAM grows long?
//
// All poses of a map are set, in each kind of bag, beside an `update` of each key frame and, on
// disk, beside one transaction of SQLite's own that writes the same numbers into a plain table. A
// register of key frames takes in one after the other, each with its window as it is fused; beside
// it what std::map takes for as many numbers. An argument names the folder of the maps on disk.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <sqlite3.h>

#include <topobag/adaptors/orb_slam/key_frame_register.hpp>
#include <topobag/adaptors/sqlite.hpp>
#include <topobag/bag/indexed_bag.hpp>

#include "adaptors/small_host.hpp"
#include "pair_times.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace topobag;

/// A run of key frames in a building of 50 × 50 m, 5 m high.
class Run {
 public:
  explicit Run(std::size_t key_frames) {
    for (std::size_t i = 0; i < key_frames; ++i) graphs_.push_back(random_graph(random_, 12));
  }

  std::size_t size() const { return graphs_.size(); }

  /// Other ones at each call.
  CameraPoses poses() {
    std::uniform_real_distribution<double> metres(-25.0, 25.0), radians(-3.0, 3.0);
    CameraPoses poses;
    for (std::uint64_t i = 0; i < size(); ++i) {
      const double x = metres(random_), y = 0.1 * metres(random_), z = metres(random_);
      poses.emplace(KeyframeId{i},
                    Eigen::Translation3d(x, y, z) *
                        Eigen::AngleAxisd(radians(random_), Eigen::Vector3d::UnitY()));
    }
    return poses;
  }

  EntryInfo info(std::uint64_t i, const CameraPoses& poses) const {
    EntryInfo info;
    info.stamp = 0.4 * static_cast<double>(i);
    info.T_world_camera = poses.at(KeyframeId{i});
    return info;
  }

  const TopologyGraph<>& graph(std::uint64_t i) const { return graphs_[i]; }

 private:
  std::mt19937 random_{1};
  std::vector<TopologyGraph<>> graphs_;
};

void print_poses(const char* bag, std::size_t size, double set, double update, double plain) {
  std::printf("%-22s %8zu %10.2f %10.2f %8.1f ", bag, size, 1e-3 * set, 1e-3 * update,
              update / set);
  if (plain > 0.0) std::printf("%10.2f %8.2f", 1e-3 * plain, set / plain);
  std::printf(
      "\n{\"bench\":\"moving_map\",\"bag\":\"%s\",\"poses\":%zu,\"set_poses_ms\":%.3f,"
      "\"update_ms\":%.3f,\"plain_ms\":%.3f}\n",
      bag, size, 1e-3 * set, 1e-3 * update, 1e-3 * plain);
}

/// @param plain_us  of the same in one transaction of SQLite's own; 0: in memory
template <typename Bag>
void bench_poses(const char* name, Bag& bag, Run& run, double plain_us = 0.0) {
  CameraPoses poses = run.poses();
  for (std::uint64_t i = 0; i < run.size(); ++i) {
    bag.add(KeyframeId{i}, run.graph(i), run.info(i, poses));
  }
  poses = run.poses();
  const double set = bench::least_time([&] { bag.set_poses(poses); });
  poses = run.poses();
  const double update = bench::least_time([&] {
    for (std::uint64_t i = 0; i < run.size(); ++i) {
      bag.update(KeyframeId{i}, run.graph(i), run.info(i, poses));
    }
  });
  print_poses(name, run.size(), set, update, plain_us);
}

/// The least time of three that one transaction takes in which SQLite gives each of so many rows
/// seven numbers, µs, with the journal that a map has.
double plain_transaction(const std::string& path, std::size_t rows) {
  sqlite3* base = nullptr;
  sqlite3_stmt* move = nullptr;
  const auto run = [&](const char* sql) {
    if (sqlite3_exec(base, sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
      throw std::runtime_error(sqlite3_errmsg(base));
    }
  };
  if (sqlite3_open(path.c_str(), &base) != SQLITE_OK) throw std::runtime_error("cannot open");
  run("PRAGMA journal_mode = wal; PRAGMA synchronous = full;");
  run("CREATE TABLE pose(id INTEGER PRIMARY KEY, a REAL, b REAL, c REAL, d REAL, e REAL, f REAL, "
      "g REAL)");
  run(("WITH RECURSIVE n(id) AS (SELECT 0 UNION ALL SELECT id + 1 FROM n WHERE id < " +
       std::to_string(rows - 1) + ") INSERT INTO pose SELECT id, 1, 2, 3, 4, 5, 6, 7 FROM n")
          .c_str());
  sqlite3_prepare_v2(base, "UPDATE pose SET a=?, b=?, c=?, d=?, e=?, f=?, g=? WHERE id=?", -1,
                     &move, nullptr);
  std::mt19937 random(1);
  std::normal_distribution<double> metres;
  const double least = bench::least_time([&] {
    run("BEGIN IMMEDIATE");
    for (std::size_t row = 0; row < rows; ++row) {
      for (int column = 1; column <= 7; ++column) sqlite3_bind_double(move, column, metres(random));
      sqlite3_bind_int64(move, 8, static_cast<sqlite3_int64>(row));
      if (sqlite3_step(move) != SQLITE_DONE) throw std::runtime_error(sqlite3_errmsg(base));
      sqlite3_reset(move);
    }
    run("COMMIT");
  });
  sqlite3_finalize(move);
  sqlite3_close(base);
  return least;
}

/// What it takes to grow a register to so many key frames, each with its window, µs for each.
double register_time(std::size_t key_frames) {
  // The register stores the host's pointers and never looks behind them.
  small_host::KeyFrame host(0, 0.0, Eigen::Isometry3d::Identity());
  std::size_t members = 0;
  const double time = bench::least_time([&] {
    KeyFrameRegister<small_host::KeyFrame> known;
    for (std::uint64_t id = 0; id < key_frames; ++id) {
      KeyframeSighting sighting;
      sighting.stamp = 0.4 * static_cast<double>(id);
      known.add(id, &host);
      known.observe(0, id, std::move(sighting));
      members += known.window_of(id, &host, 3.0).size();
    }
  });
  if (members < key_frames) throw std::runtime_error("a window is empty");
  return time / static_cast<double>(key_frames);
}

/// The same of a map of numbers.
double plain_map_time(std::size_t numbers) {
  std::size_t found = 0;
  const double time = bench::least_time([&] {
    std::map<std::uint64_t, double> known;
    for (std::uint64_t id = 0; id < numbers; ++id) {
      known.emplace(id, 0.4 * static_cast<double>(id));
      found += known.count(id / 2);
    }
  });
  if (found < numbers) throw std::runtime_error("a number is lost");
  return time / static_cast<double>(numbers);
}

void bench_register() {
  std::printf("\n%10s %16s %10s %16s %10s\n", "key frames", "register, us", "x first",
              "std::map, us", "x first");
  double first = 0.0, plain_first = 0.0;
  for (const std::size_t size : {1000U, 10000U, 100000U}) {
    const double time = register_time(size), plain = plain_map_time(size);
    if (first == 0.0) first = time, plain_first = plain;
    std::printf("%10zu %16.3f %10.2f %16.3f %10.2f\n", size, time, time / first, plain,
                plain / plain_first);
    std::printf(
        "{\"bench\":\"key_frame_register\",\"key_frames\":%zu,\"each_us\":%.3f,"
        "\"ratio\":%.2f,\"map_us\":%.3f,\"map_ratio\":%.2f}\n",
        size, time, time / first, plain, plain / plain_first);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc > 1) setenv("TMPDIR", argv[1], 1);
    std::printf("%-22s %8s %10s %10s %8s %10s %8s\n", "bag", "poses", "set, ms", "update", "x",
                "SQLite", "set x");
    for (const std::size_t size : {500U, 5000U}) {
      const ScratchFolder folder;
      Run run(size);
      const double plain = plain_transaction(folder.path("plain.db"), size);
      BagOfTopologyGraphs<> memory;
      bench_poses("BagOfTopologyGraphs", memory, run);
      IndexedBag indexed;
      bench_poses("IndexedBag", indexed, run);
      SqliteBag<> durable(folder.path("map.db"));
      bench_poses("SqliteBag", durable, run, plain);
      SqliteBag<IndexedBag> both(folder.path("both.db"));
      bench_poses("SqliteBag<IndexedBag>", both, run, plain);
    }
    bench_register();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
