// SPDX-License-Identifier: MIT
#include <topobag/adaptors/sqlite_options.hpp>

#include <vector>

#include <topobag/adaptors/sqlite.hpp>

#include "catch.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

TEST_CASE("views are kept in a map on disk unless they are left out", "[sqlite]") {
  const ScratchFolder folder;
  const TopologyGraph<> graph(std::vector<SemanticNode<>>(3), {}, std::vector<View<>>(2));
  SqliteOptions without;
  without.views = ViewSection::left_out;
  SqliteBag<> keeping(folder.path("keeping.db")), leaving(folder.path("leaving.db"), without);
  keeping.add(KeyframeId{1}, graph);
  leaving.add(KeyframeId{1}, graph);
  CHECK(keeping.find(KeyframeId{1})->views().size() == 2);
  CHECK(leaving.find(KeyframeId{1})->views().empty());
}
