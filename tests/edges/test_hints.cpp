// SPDX-License-Identifier: MIT
#include <topobag/edges/hints.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the last used vertex is suggested, and copied", "[edges][delaunay]") {
  LastUsedVertexHint hint;
  CHECK_FALSE(hint.suggest({1, 2}).has_value());
  hint.notice(node_index(4));
  CHECK(hint.suggest({1, 2}) == node_index(4));
  LastUsedVertexHint copy(hint);
  hint.notice(node_index(5));
  CHECK(copy.suggest({0, 0}) == node_index(4));
  copy = hint;
  CHECK(copy.suggest({0, 0}) == node_index(5));
}

TEST_CASE("a hierarchy needs no suggestion", "[edges][delaunay]") {
  HierarchyHint hint;
  hint.notice(node_index(4));
  CHECK_FALSE(hint.suggest({1, 2}).has_value());
}
