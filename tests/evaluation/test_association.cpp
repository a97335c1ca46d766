// SPDX-License-Identifier: MIT
#include <topobag/evaluation/association.hpp>

#include "catch.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;

TEST_CASE("estimates are paired with the truth at their own time", "[evaluation]") {
  Trajectory truth;
  for (int i = 0; i < 20; ++i) truth.push_back({i * 0.4, topobag_tests::planar_pose(i, 0, 0)});
  const Trajectory estimate{{-1.0, {}}, {1.0, {}}, {3.2, {}}, {9.0, {}}};
  const auto pairs = associate(truth, estimate);
  REQUIRE(pairs.size() == 2);
  CHECK(pairs[0].stamp == 1.0);
  CHECK(pairs[0].T_true.translation().x() == Approx(2.5));
  CHECK(pairs[1].T_true.translation().x() == Approx(8.0));
  CHECK(associate(truth, estimate, 0.2).size() == 1);
  CHECK(associate({}, estimate).empty());
  CHECK(associate(truth, {}).empty());
}
