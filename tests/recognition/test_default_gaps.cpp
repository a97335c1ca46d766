// SPDX-License-Identifier: MIT
#include <cmath>

#include <topobag/bag/place_count.hpp>
#include <topobag/recognition/certain_negatives.hpp>
#include <topobag/recognition/place_options.hpp>
#include <topobag/recognition/place_score.hpp>
#include <topobag/recognition/temporal_consistency.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("without poses, one number of key frames tells places of a session apart",
          "[recognition]") {
  CHECK(PlaceOptions{}.min_id_gap == PoseNegativeOptions{}.min_id_gap);
  // At a key frame each 0.4 s.
  CHECK(0.4 * static_cast<double>(PlaceOptions{}.min_id_gap) == PlaceCount::seconds_per_place);
}

TEST_CASE("cameras of one place and the steps of one motion differ by as much", "[recognition]") {
  // By 30°, of which each has kept the decimals that its results rest on.
  CHECK(PlaceScale{}.translation == TemporalOptions{}.max_translation);
  CHECK(PlaceScale{}.rotation == Approx(TemporalOptions{}.max_rotation).margin(5e-5));
  CHECK(PlaceScale{}.rotation == Approx(std::acos(-1.0) / 6.0).margin(5e-5));
}
