// SPDX-License-Identifier: MIT
#include <topobag/types/dynamics.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a set of dynamics holds what it was given and no more", "[types]") {
  constexpr Dynamics levels[] = {Dynamics::low, Dynamics::medium, Dynamics::high};
  for (const Dynamics one : levels) {
    for (const Dynamics other : levels) {
      CHECK(DynamicsSet{one}.contains(other) == (one == other));
      for (const Dynamics third : levels) {
        CHECK(DynamicsSet{one, other}.contains(third) == (third == one || third == other));
      }
    }
    CHECK_FALSE(DynamicsSet({}).contains(one));
  }
}
