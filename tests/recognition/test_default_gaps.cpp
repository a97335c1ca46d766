// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/bag/place_count.hpp>
#include <topobag/recognition/certain_negatives.hpp>
#include <topobag/recognition/place_options.hpp>
#include <topobag/recognition/place_score.hpp>
#include <topobag/recognition/temporal_consistency.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("without poses, ids of one session tell places apart by one number", "[recognition]") {
  CHECK(PlaceOptions{}.min_id_gap == PlaceCount::ids_per_place);
  CHECK(PoseNegativeOptions{}.min_id_gap == PlaceCount::ids_per_place);
}

TEST_CASE("cameras of one place and the steps of one motion differ by as much", "[recognition]") {
  // By 30°, of which each has kept the decimals that its results rest on.
  CHECK(PlaceScale{}.translation == TemporalOptions{}.max_translation);
  CHECK(PlaceScale{}.rotation == Approx(TemporalOptions{}.max_rotation).margin(5e-5));
  CHECK(PlaceScale{}.rotation == Approx(std::acos(-1.0) / 6.0).margin(5e-5));
}
