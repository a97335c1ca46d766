// SPDX-License-Identifier: MIT
#include <limits>
#include <string>

#include <topobag/edges/insertion_error.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("a coordinate is refused exactly outside its range", "[edges][delaunay]") {
  using Limits = std::numeric_limits<double>;
  for (const double sign : {1.0, -1.0}) {
    CHECK_FALSE(validate_coordinate(sign * 0.0));
    CHECK_FALSE(validate_coordinate(sign * min_allowed_value));
    CHECK_FALSE(validate_coordinate(sign * max_allowed_value));
    CHECK(validate_coordinate(sign * std::nextafter(min_allowed_value, 0.0)) ==
          CoordinateFault::too_small);
    CHECK(validate_coordinate(sign * Limits::denorm_min()) == CoordinateFault::too_small);
    CHECK(validate_coordinate(sign * std::nextafter(max_allowed_value, 1e300)) ==
          CoordinateFault::too_large);
    CHECK(validate_coordinate(sign * Limits::max()) == CoordinateFault::too_large);
    CHECK(validate_coordinate(sign * Limits::infinity()) == CoordinateFault::infinite);
    CHECK(validate_coordinate(sign * Limits::quiet_NaN()) == CoordinateFault::nan);
  }
}

TEST_CASE("mitigate_underflow makes a coordinate acceptable and changes no other",
          "[edges][delaunay]") {
  CHECK(mitigate_underflow(1e-300) == 0.0);
  CHECK(mitigate_underflow(-min_allowed_value) == -min_allowed_value);
  CHECK(mitigate_underflow(-3.5) == -3.5);
}

TEST_CASE("an insertion error says which vertex and what to do", "[edges][delaunay]") {
  const Eigen::Vector3d position(1.0, std::numeric_limits<double>::infinity(), 1e300);
  try {
    validate_position(position, 7);
    FAIL("accepted an infinite coordinate");
  } catch (const InvalidValue& error) {
    CHECK(error.index() == 7u);
    CHECK(std::string(error.what()) ==
          "The position of vertex 7 has an infinite coordinate: leave it out.");
  }
  CHECK_THROWS_AS(validate_position(Eigen::Vector2f(0.0f, 1e-45f)), InsertionError);
  CHECK_NOTHROW(validate_position(Eigen::Vector2f(0.0f, 1e38f)));
}
