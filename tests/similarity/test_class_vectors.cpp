// SPDX-License-Identifier: MIT
#include <limits>

#include <topobag/similarity/class_vectors.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("classes are one-hot until they get a vector", "[similarity]") {
  ClassVectors vectors;
  CHECK(dot(vectors(ClassId{1}), vectors(ClassId{1})) == 1.0);
  CHECK(dot(vectors(ClassId{1}), vectors(ClassId{2})) == 0.0);

  vectors.set(ClassId{1}, Eigen::Vector2d(3.0, 4.0));
  vectors.set(ClassId{2}, Eigen::Vector2d(4.0, 3.0));
  CHECK(dot(vectors(ClassId{1}), vectors(ClassId{2})) == Approx(24.0 / 25.0));
  CHECK(dot(vectors(ClassId{1}), vectors(ClassId{1})) == Approx(1.0));
  // Dimension 0 or 1 of a vector is not class 0 or 1.
  CHECK(dot(vectors(ClassId{1}), vectors(ClassId{0})) == 0.0);
}

TEST_CASE("a vector has to be finite and not zero", "[similarity]") {
  ClassVectors vectors;
  const double inf = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(vectors.set(ClassId{1}, Eigen::Vector2d(1.0, inf)), InvalidValue);
  CHECK_THROWS_AS(vectors.set(ClassId{1}, Eigen::Vector2d::Zero()), InvalidValue);
  CHECK_THROWS_AS(vectors.set(ClassId{1}, Eigen::VectorXd()), InvalidValue);
}
