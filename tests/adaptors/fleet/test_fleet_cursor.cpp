// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <topobag/adaptors/postgres.hpp>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

/// The versions' numbers from a cursor on, which moves with them.
std::vector<std::int64_t> read_on(PostgresStore& store, FleetCursor& cursor, std::size_t page) {
  std::vector<std::int64_t> read;
  for (;;) {
    const auto rows = store.read("hall", cursor, page);
    if (rows.empty()) return read;
    for (const ReadVersion& row : rows) read.push_back(row.version.seq);
  }
}

}  // namespace

TEST_CASE("a cursor goes on where it was, and anew on a server of another history",
          "[fleet][postgres]") {
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(6);
  PostgresStore store(shared_postgres().new_base());
  store.prepare();
  store.add_site("hall", 0);
  std::vector<FleetVersion> versions;
  for (std::uint64_t i = 0; i < 12; ++i) {
    versions.push_back(
        version_of({"hall", Uuid{1}, Uuid{2}, KeyframeId{i}}, {}, random_graph(random, 3)));
    versions.back().seq = static_cast<std::int64_t>(i) + 1;
  }
  store.append(versions);
  FleetCursor all;
  const std::vector<std::int64_t> in_order = read_on(store, all, 100);
  REQUIRE(in_order.size() == 12);
  CHECK(read_on(store, all, 100).empty());
  CHECK(all.seq == in_order.back());

  for (std::size_t first = 1; first < 12; ++first) {
    FleetCursor cursor;
    REQUIRE(store.read("hall", cursor, first).size() == first);
    FleetCursor kept = cursor;  // as a follower keeps it while it is off
    const auto rest = in_order.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<std::int64_t> expected(rest, in_order.end());
    CHECK(read_on(store, cursor, 1 + first % 5) == expected);
    CHECK(read_on(store, kept, 4) == expected);
    kept.history = "of a server that is gone";
    CHECK(read_on(store, kept, 5) == in_order);
  }
}
