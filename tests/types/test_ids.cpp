// SPDX-License-Identifier: MIT
#include <type_traits>

#include <topobag/types/ids.hpp>

#include "catch.hpp"

using namespace topobag;

// Strong types: neither a number nor one another.
static_assert(!std::is_convertible_v<int, ClassId> && !std::is_convertible_v<ClassId, int>);
static_assert(!std::is_convertible_v<KeyframeId, NodeIndex>);

TEST_CASE("ids keep the whole range of their numbers", "[types]") {
  CHECK(value(ClassId{-1}) == -1);
  CHECK(value(KeyframeId{18446744073709551615U}) == 18446744073709551615U);
  CHECK(value(node_index(4294967295U)) == 4294967295U);
}

TEST_CASE("ids order by their number", "[types]") {
  CHECK(ClassId{2} < ClassId{10});
  CHECK(KeyframeId{9} < KeyframeId{9223372036854775808U});
}
