// SPDX-License-Identifier: MIT
#include <iostream>
#include <string>

#include "catch.hpp"
#include "long_rounds.hpp"
#include "warehouse_visits.hpp"

namespace {

std::ostream& operator<<(std::ostream& out, const WarehouseFigures& figures) {
  return out << figures.queries << " queries, " << figures.correct << " correct, "
             << figures.imprecise << " imprecise, " << figures.wrong << " wrong; of "
             << figures.refused() << " refused " << figures.rivalled << " for another place";
}

}  // namespace

TEST_CASE(
    "in a warehouse of equal racks a second round is found and never wrong, and of aisles that "
    "were "
    "never mapped at most two in a hundred are taken for others",
    "[recognition][long]") {
  for (const double jitter : {0.03, 0.12}) {
    for (const bool gravity : {false, true}) {
      WarehouseFigures second, other;
      for (const double filled : {0.6, 0.8, 1.0}) {
        for (unsigned seed = 0; seed < long_rounds(3); ++seed) {
          WarehouseMap map(seed, {jitter, filled, gravity});
          second += map.second_round();
          other += map.other_aisles();
        }
      }
      std::cout << "warehouse, jitter " << jitter << " m" << (gravity ? ", gravity" : "")
                << ": second round " << second << "; aisles that were never mapped " << other
                << '\n';
      // Racks that differ by less than what is measured are told apart by their empty slots alone.
      CHECK(100 * second.correct >= (jitter < 0.1 ? 25 : 90) * second.queries);
      CHECK(second.wrong == 0);
      CHECK(100 * other.accepted() <= 2 * other.queries);
      // Every refusal for another place names it.
      CHECK(second.told == second.rivalled);
      CHECK(other.told == other.rivalled);
    }
  }
}
