// SPDX-License-Identifier: MIT
#include <random>
#include <string>
#include <vector>

#include <topobag/adaptors/postgres.hpp>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

TEST_CASE("versions are read in the order of their transactions, page by page", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(1);
  PostgresStore store(shared_postgres().new_base());
  store.prepare();
  store.add_site("hall", 0);
  std::vector<FleetVersion> versions;
  for (std::uint64_t i = 0; i < 10; ++i) {
    versions.push_back(version_of({"hall", Uuid{1}, Uuid{static_cast<std::uint8_t>(i % 2)}, KeyframeId{i}},
                                  {}, random_graph(random, 4)));
    versions.back().seq = static_cast<std::int64_t>(i) + 1;
  }
  CHECK(store.append({versions.begin() + 6, versions.end()}) == 4);
  CHECK(store.append(versions) == 6);
  CHECK(store.append({}) == 0);
  CHECK(store.last_seq("hall", Uuid{1}, {Uuid{0}}) == 9);
  CHECK(store.last_seq("hall", Uuid{1}, {Uuid{0}, Uuid{1}}) == 10);
  CHECK(store.last_seq("hall", Uuid{2}, {Uuid{0}}) == 0);
  FleetCursor cursor;
  std::vector<std::int64_t> read;
  for (;;) {
    const auto page = store.read("hall", cursor, 3);
    if (page.empty()) break;
    CHECK(page.size() <= 3);
    for (const ReadVersion& row : page) {
      CHECK(row.fault.empty());
      CHECK(row.version.graph == versions[static_cast<std::size_t>(row.version.seq) - 1].graph);
      read.push_back(row.version.seq);
    }
  }
  CHECK(read == std::vector<std::int64_t>{7, 9, 8, 10, 1, 3, 5, 2, 4, 6});
  REQUIRE(store.sites().size() == 1);
  CHECK(store.sites().front().versions == 10);
  CHECK(store.sites().front().robots == 1);
}

TEST_CASE("a batch that contradicts the server adds nothing", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(2);
  PostgresStore store(shared_postgres().new_base());
  store.prepare();
  store.add_site("hall", 0);
  const auto version = [&](std::int64_t seq) {
    FleetVersion made = version_of({"hall", Uuid{1}, Uuid{2}, KeyframeId{7}}, {},
                                   random_graph(random, 5));
    made.seq = seq;
    return made;
  };
  CHECK(store.append({version(1)}) == 1);
  CHECK_THROWS_AS(store.append({version(1), version(2)}), InvalidId);
  CHECK(store.last_seq("hall", Uuid{1}, {Uuid{2}}) == 1);
  CHECK(store.append({version(2)}) == 1);
}
