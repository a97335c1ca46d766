// SPDX-License-Identifier: MIT
#include <atomic>
#include <random>
#include <string>
#include <thread>
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
    versions.push_back(
        version_of({"hall", Uuid{1}, Uuid{static_cast<std::uint8_t>(i % 2)}, KeyframeId{i}}, {},
                   random_graph(random, 4)));
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
  CHECK(store.site_names() == std::vector<std::string>{"hall"});
}

TEST_CASE("a batch that contradicts the server adds nothing", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  std::mt19937 random(2);
  PostgresStore store(shared_postgres().new_base());
  store.prepare();
  store.add_site("hall", 0);
  const auto version = [&](std::int64_t seq) {
    FleetVersion made =
        version_of({"hall", Uuid{1}, Uuid{2}, KeyframeId{7}}, {}, random_graph(random, 5));
    made.seq = seq;
    return made;
  };
  CHECK(store.append({version(1)}) == 1);
  CHECK_THROWS_AS(store.append({version(1), version(2)}), InvalidId);
  CHECK(store.last_seq("hall", Uuid{1}, {Uuid{2}}) == 1);
  CHECK(store.append({version(2)}) == 1);
}

TEST_CASE("a data base that many prepare at once is prepared once, a partition for each site",
          "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  const std::string conninfo = shared_postgres().new_base();
  std::vector<std::thread> owners;
  std::atomic<int> prepared{0};
  for (int i = 0; i < 4; ++i) {
    owners.emplace_back([&] {
      PostgresStore(conninfo).prepare();
      ++prepared;
    });
  }
  for (std::thread& owner : owners) owner.join();
  CHECK(prepared == 4);
  const auto number = [&](const std::string& sql) {
    return std::stoi(shared_postgres().sql(sql, conninfo));
  };
  CHECK(number("SELECT schema_version FROM topobag.meta") == postgres_schema_version);
  PostgresStore store(conninfo);
  for (const char* site : {"hall", "yard", "attic"}) store.add_site(site, 0);
  CHECK_THROWS_AS(store.add_site("hall", 0), Error);
  CHECK_THROWS_AS(store.add_site("", 0), Error);
  CHECK(store.site_names() == std::vector<std::string>{"attic", "hall", "yard"});
  CHECK(number("SELECT count(*) FROM pg_inherits WHERE inhparent = 'topobag.version'::regclass") ==
        3);
}
