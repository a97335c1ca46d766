// SPDX-License-Identifier: MIT
// Does a writer slow the readers of an indexed bag down?
//
// Readers query as fast as they can, first alone, then while another thread adds 100 graphs a
// second; in turns, so that a noisy neighbour slows both alike. The ratio is the median over the
// turns.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

#include <topobag/bag/indexed_bag.hpp>

#include "drive.hpp"

namespace {

using Graph = topobag::TopologyGraph<>;
using Clock = std::chrono::steady_clock;

/// Queries a second of `readers` threads during `time`, while `write` runs on this one.
template <typename Write>
double throughput(const topobag::IndexedBag& bag, const std::vector<Graph>& queries,
                  std::size_t readers, std::chrono::milliseconds time, const Write& write) {
  std::atomic<bool> stop{false};
  std::atomic<std::size_t> answered{0};
  std::vector<std::thread> threads;
  for (std::size_t reader = 0; reader < readers; ++reader) {
    threads.emplace_back([&, reader] {
      for (std::size_t i = reader; !stop; ++i) {
        if (!bag.view()->query(queries[i % queries.size()]).empty()) ++answered;
      }
    });
  }
  write(Clock::now() + time);
  stop = true;
  const std::size_t total = answered;
  for (std::thread& thread : threads) thread.join();
  return static_cast<double>(total) / std::chrono::duration<double>(time).count();
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> sets{TOPOBAG_SOURCES "/examples/data/fr1_xyz",
                                TOPOBAG_SOURCES "/examples/data/fr1_rpy"};
  std::size_t graphs = 100000, readers = 4, turns = 7;
  CLI::App app("Readers with and without a writer");
  app.add_option("--graphs", graphs, "in the bag");
  app.add_option("--readers", readers, "threads that query");
  app.add_option("--nodes", sets, "node tables whose graphs are the pieces");
  CLI11_PARSE(app, argc, argv);

  Drive drive(graphs_of_tables(sets), 1);
  topobag::IndexedBag bag;
  std::uint64_t next = 0;
  for (; next < graphs; ++next) bag.add(topobag::KeyframeId{next}, drive.next());
  std::vector<Graph> queries;
  for (int i = 0; i < 200; ++i) queries.push_back(drive.revisit());

  const std::chrono::milliseconds time(2000);
  const auto rest = [](Clock::time_point end) { std::this_thread::sleep_until(end); };
  const auto add = [&](Clock::time_point end) {
    for (auto at = Clock::now(); at < end; at += std::chrono::milliseconds(10)) {
      std::this_thread::sleep_until(at);
      bag.add(topobag::KeyframeId{next++}, drive.next());
    }
  };
  std::vector<double> alone, ratios;
  for (std::size_t turn = 0; turn < turns; ++turn) {
    const double without = throughput(bag, queries, readers, time, rest);
    const double with = throughput(bag, queries, readers, time, add);
    alone.push_back(without);
    ratios.push_back(with / without);
  }
  std::sort(alone.begin(), alone.end());
  std::sort(ratios.begin(), ratios.end());
  std::printf(
      "{\"bench\":\"bag_readers\",\"graphs\":%zu,\"readers\":%zu,\"alone_per_s\":%.0f,"
      "\"ratio_with_writer\":%.3f}\n",
      graphs, readers, alone[turns / 2], ratios[turns / 2]);
}
