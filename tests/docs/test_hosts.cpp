// SPDX-License-Identifier: MIT
// The code of hosts.md, on a small host.
#include <vector>

#include <topobag/adaptors/orb_slam.hpp>
#include <topobag/recognition/calibrate.hpp>

#include "adaptors/atlas_host.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("a database is calibrated beside its host", "[docs]") {
  atlas_host::Session session(3);
  for (int i = 0; i < 3; ++i) session.mapped(i, session.first);
  atlas_host::Database& database = session.database;
  atlas_host::Map& map = session.first;

  const Relocalizer<> copy = database.copy_of(&map);  // hosts with one map: copy_of()
  std::vector<KeyframeId> ids;
  copy.map().for_each([&](KeyframeId id, const EntryInfo&, const auto&) { ids.push_back(id); });
  RecognitionOptions running = database.options();
  running.decision.calibration = calibrate(copy, ids);
  running.decision.false_accept_rate = 0.01;
  database.set_options(running);

  CHECK(ids.size() == 3);
  CHECK(database.options().decision.calibration->queries() > 0);
}
