// SPDX-License-Identifier: MIT
#include <topobag/adaptors/fleet/enlist_with_server.hpp>

#include <string>

#include <topobag/adaptors/fleet_bag.hpp>

#include "adaptors/postgres_server.hpp"
#include "catch.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

TEST_CASE("a server that would not take a map leaves it as it was", "[fleet][regression]") {
  if (!PostgresServer::is_installed()) return;
  const ScratchFolder folder;
  const std::string path = folder.path("map.db");
  { const SqliteBag<> map(path); }
  const std::string before = content_of(path);
  PostgresStore store(shared_postgres().new_base());
  store.prepare();
  store.add_site("hall", 0);
  store.add_site("depot", 77);
  CHECK_THROWS_AS(enlist(path, "depot", store), FormatError);
  CHECK_THROWS_AS(enlist(path, "attic", store), Error);
  PostgresStore nowhere("host=" + folder.path() + " dbname=none");
  CHECK_THROWS_AS(enlist(path, "hall", nowhere), Error);
  CHECK(content_of(path) == before);

  enlist(path, "hall", store, Uuid{7});
  CHECK(FleetOutbox(path).member().robot == Uuid{7});
  enlist(path, "hall", nowhere);  // an outbox already: nobody is asked
  CHECK_THROWS_AS(enlist(path, "depot", store), InvalidId);
  FleetCursor cursor;
  CHECK(store.read("hall", cursor).empty());  // asked, and nothing was added
}

TEST_CASE("a store says what it would take, and which roles there are", "[postgres]") {
  if (!PostgresServer::is_installed()) return;
  PostgresStore store(shared_postgres().new_base());
  store.prepare();
  store.add_site("hall", 0);
  FleetVersion version;
  version.key = {"hall", Uuid{1}, Uuid{2}, KeyframeId{3}};
  version.seq = 1;
  version.tombstone = true;
  store.require_taken(version);
  CHECK(store.sites().front().versions == 0);
  CHECK(store.append({version}) == 1);
  version.key.keyframe = KeyframeId{4};
  CHECK_THROWS_AS(store.require_taken(version), InvalidId);
  CHECK(store.has_role("owner"));
  CHECK_FALSE(store.has_role("nobody'; DROP TABLE x; --"));
}
