// SPDX-License-Identifier: MIT
#include <iostream>
#include <string>

#include "catch.hpp"
#include "long_rounds.hpp"
#include "warehouse_visits.hpp"

namespace {

std::ostream& operator<<(std::ostream& out, const WarehouseFigures& figures) {
  return out << figures.look_ups << " look-ups, " << figures.correct << " correct, "
             << figures.imprecise << " imprecise, " << figures.wrong << " wrong; of "
             << figures.refused() << " refused " << figures.rivalled << " for another place";
}

}  // namespace

TEST_CASE(
    "in a warehouse of equal racks seven in ten of a second round are found, and at most one "
    "in a hundred is wrong",
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
      CHECK(10 * second.correct >= 7 * second.look_ups);
      CHECK(100 * second.wrong <= second.look_ups);
      // Racks that are nowhere in the map are still taken for their like, as long as one of these
      // leads by more than noise does; so this bounds what is, and is not what one would wish.
      CHECK(100 * other.accepted() <= 30 * other.look_ups);
      // Every refusal for another place names it.
      CHECK(second.told == second.rivalled);
      CHECK(other.told == other.rivalled);
    }
  }
}
