// SPDX-License-Identifier: MIT
// What does a fleet's server take and give?
//
// On a PostgreSQL of its own, with fsync: versions a second pushed by 1, 8 and 32 robots at once in
// batches, beside COPY of the same bytes by one connection, in turns, into a table without and with
// the fleet's indexes; how long a pushed key frame takes to a follower; and a server of many sites:
// bytes on disk, how fast it is filled at first and in the end, how long a new follower of one site
// takes to catch up and the memory that it has then, and to index a site anew.
//   bench_fleet [ROWS [BATCH [ROWS_OF_A_SITE [SITES]]]]
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/postgres_server.hpp"
#include "fleet_versions.hpp"
#include "postgres_copy.hpp"

namespace {

using Clock = std::chrono::steady_clock;
using Versions = std::vector<topobag::FleetVersion>;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Versions a second of so many robots at once, whose connections are there, as COPY's is.
double pushed(const std::string& conninfo, const Versions& versions, std::size_t robots,
              std::size_t batch) {
  std::vector<topobag::PostgresStore> stores;
  for (std::size_t robot = 0; robot < robots; ++robot) {
    stores.emplace_back(conninfo);
    stores.back().site_names();
  }
  std::vector<std::thread> threads;
  const auto start = Clock::now();
  for (std::size_t robot = 0; robot < robots; ++robot) {
    threads.emplace_back([&, robot] {
      topobag::PostgresStore& store = stores[robot];
      const topobag::Uuid uuid = topobag::random_uuid();
      const std::size_t share = versions.size() / robots;
      for (std::size_t at = robot * share; at < (robot + 1) * share; at += batch) {
        const std::size_t end = std::min(at + batch, (robot + 1) * share);
        Versions part(versions.begin() + static_cast<std::ptrdiff_t>(at),
                      versions.begin() + static_cast<std::ptrdiff_t>(end));
        for (auto& version : part) version.key.robot = uuid;
        store.append(part);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  return static_cast<double>(versions.size()) / seconds_since(start);
}

std::string fleet_base(PostgresServer& server) {
  const std::string conninfo = server.new_base();
  topobag::PostgresStore store(conninfo);
  store.prepare();
  store.add_site("hall", 0);
  return conninfo;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// What a call's rows take of the processors, the server's and this process', µs a row: where
/// others are at work, that says more than a rate.
template <typename Call>
double processor_us(const PostgresServer& server, std::size_t rows, const Call& call) {
  const auto spent = [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // till connections have ended
    return server.processor_seconds() + static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  };
  const double before = spent();
  call();
  return 1e6 * (spent() - before) / static_cast<double>(rows);
}

/// Push and COPY in turns, since the machine may have other work; medians over the turns.
void measure_rates(PostgresServer& server, const Versions& versions, std::size_t batch) {
  constexpr std::size_t turns = 5;
  for (const std::size_t robots : {std::size_t{1}, std::size_t{8}, std::size_t{32}}) {
    std::vector<double> push, bare, indexed, of_bare, of_indexed, push_us, bare_us, indexed_us;
    std::string bytes;
    for (std::size_t turn = 0; turn < turns; ++turn) {
      const std::string conninfo = fleet_base(server);
      server.sql(
          "CREATE TABLE bare (LIKE topobag.version);"
          "CREATE TABLE indexed (LIKE topobag.version INCLUDING INDEXES)",
          conninfo);
      const auto timed = [&](std::vector<double>& rates, std::vector<double>& costs,
                             const auto& call) {
        costs.push_back(processor_us(server, versions.size(), [&] { rates.push_back(call()); }));
      };
      timed(push, push_us, [&] { return pushed(conninfo, versions, robots, batch); });
      const std::vector<std::string> lines = copied_lines(conninfo);
      timed(bare, bare_us, [&] { return copy_lines(conninfo, "bare", lines, batch); });
      timed(indexed, indexed_us, [&] { return copy_lines(conninfo, "indexed", lines, batch); });
      of_bare.push_back(push.back() / bare.back());
      of_indexed.push_back(push.back() / indexed.back());
      bytes = server.sql(
          "SELECT sum(pg_total_relation_size(relid)) / (SELECT count(*) FROM topobag.version)"
          " FROM pg_partition_tree('topobag.version')",
          conninfo);
    }
    std::printf(
        "{\"bench\":\"fleet_push\",\"robots\":%zu,\"batch\":%zu,\"versions\":%zu,"
        "\"turns\":%zu,\"push_per_s\":%.0f,\"copy_per_s\":%.0f,"
        "\"copy_indexed_per_s\":%.0f,\"push_of_copy\":%.2f,"
        "\"push_of_copy_indexed\":%.2f,\"push_processor_us\":%.1f,\"copy_processor_us\":%.1f,"
        "\"copy_indexed_processor_us\":%.1f,\"bytes_per_row\":%s}\n",
        robots, batch, versions.size(), turns, median(push), median(bare), median(indexed),
        median(of_bare), median(of_indexed), median(push_us), median(bare_us), median(indexed_us),
        bytes.substr(0, bytes.find('.')).c_str());
    std::fflush(stdout);
  }
}

/// From the call that pushes a key frame until a follower's bag holds it.
void measure_delay(PostgresServer& server, const Versions& versions, std::size_t rounds) {
  const std::string conninfo = fleet_base(server);
  topobag::FleetBag fleet({{conninfo, {"hall"}}});
  fleet.follow();
  std::vector<double> delays;
  std::vector<Clock::time_point> starts(rounds);
  std::thread robot([&] {
    topobag::PostgresStore store(conninfo);
    for (std::size_t i = 0; i < rounds; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      starts[i] = Clock::now();
      store.append({versions[i]});
    }
  });
  while (delays.size() < rounds) {
    fleet.wait();
    fleet.follow();
    while (delays.size() < fleet.size()) {
      delays.push_back(1000.0 * seconds_since(starts[delays.size()]));
    }
  }
  robot.join();
  std::sort(delays.begin(), delays.end());
  std::printf("{\"bench\":\"fleet_delay\",\"pushes\":%zu,\"median_ms\":%.2f,\"p99_ms\":%.2f}\n",
              rounds, delays[rounds / 2], delays[rounds * 99 / 100]);
  std::fflush(stdout);
}

/// Bytes of the process that are in memory.
double resident() {
  std::size_t all = 0, pages = 0;
  std::ifstream("/proc/self/statm") >> all >> pages;
  return static_cast<double>(pages) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// A follower of one site that knows nothing yet.
void measure_catch_up(const std::string& conninfo) {
  const double before = resident();
  topobag::FleetBag fleet({{conninfo, {"hall"}}});
  const auto start = Clock::now();
  const std::clock_t clock = std::clock();
  const auto taken = static_cast<double>(fleet.follow());
  const double took = seconds_since(start);
  const double own = static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
  const topobag::MemoryUsage memory = fleet.view()->memory_usage();
  std::printf(
      "{\"bench\":\"fleet_catch_up\",\"versions\":%.0f,\"seconds\":%.2f,"
      "\"processor_seconds\":%.2f,\"per_s\":%.0f,\"bag_bytes_per_keyframe\":%.0f,"
      "\"resident_bytes_per_keyframe\":%.0f}\n",
      taken, took, own, taken / took,
      static_cast<double>(memory.graphs + memory.index + memory.entries) / taken,
      (resident() - before) / taken);
  std::fflush(stdout);
}

/// A server of so many sites, each with the rows of the first, which is pushed; the server copies
/// the others itself.
void measure_sites(PostgresServer& server, Versions versions, std::size_t batch,
                   std::size_t sites) {
  const std::string conninfo = fleet_base(server);
  topobag::PostgresStore store(conninfo);
  const double first_push = pushed(conninfo, versions, 8, batch);
  for (std::size_t site = 1; site < sites; ++site) {
    const std::string name = "site " + std::to_string(site);
    store.add_site(name, 0);
    server.sql("INSERT INTO topobag.version SELECT '" + name + "', md5('" + name +
                   "' || robot)::uuid, session, seq, keyframe, run, stamp, label, tx, ty, tz, qx,"
                   " qy, qz, qw, graph, catalog, appearance, checksum, tombstone"
                   " FROM topobag.version WHERE site = 'hall'",
               conninfo);
  }
  versions.resize(std::min<std::size_t>(versions.size(), 20000));
  for (auto& version : versions) version.key.site = "yard";
  versions.shrink_to_fit();
  store.add_site("yard", 0);
  const double last_push = pushed(conninfo, versions, 8, batch);
  const double rows = std::stod(server.sql("SELECT count(*) FROM topobag.version", conninfo));
  const double bytes = std::stod(server.sql(
      "SELECT sum(pg_total_relation_size(relid)) FROM pg_partition_tree('topobag.version')",
      conninfo));
  const auto start = Clock::now();
  server.sql("REINDEX TABLE topobag.site_" + server.sql("SELECT md5('hall')"), conninfo);
  const double reindexed = seconds_since(start);
  std::printf(
      "{\"bench\":\"fleet_sites\",\"sites\":%zu,\"versions\":%.0f,"
      "\"bytes_per_row\":%.0f,\"first_push_per_s\":%.0f,\"last_push_per_s\":%.0f,"
      "\"reindex_site_seconds\":%.1f}\n",
      sites + 1, rows, bytes / rows, first_push, last_push, reindexed);
  std::fflush(stdout);
  versions = {};
  measure_catch_up(conninfo);
}

}  // namespace

int main(int argc, char** argv) {
  if (!PostgresServer::is_installed()) return 0;
  const std::size_t rows = argc > 1 ? std::stoul(argv[1]) : 100000;
  const std::size_t batch = argc > 2 ? std::stoul(argv[2]) : 1000;
  const std::size_t rows_of_a_site = argc > 3 ? std::stoul(argv[3]) : rows;
  const std::size_t sites = argc > 4 ? std::stoul(argv[4]) : 1;
  PostgresServer server({"fsync=on", "shared_buffers=256MB", "max_wal_size=8GB"});
  if (rows > 0) {
    const Versions versions = some_fleet_versions(rows);
    measure_rates(server, versions, batch);
    measure_delay(server, versions, std::min<std::size_t>(rows, 1000));
  }
  measure_sites(server, some_fleet_versions(rows_of_a_site), batch, sites);
}
