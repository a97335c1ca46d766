// SPDX-License-Identifier: MIT
#include <topobag/evaluation/trajectory_error.hpp>

#include "catch.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;
using topobag_tests::planar_pose;

TEST_CASE("statistics of a hand-made list", "[evaluation]") {
  CHECK_FALSE(error_statistics({}));
  const auto one = error_statistics({3.0});
  CHECK(one->median == 3.0);
  const auto odd = error_statistics({5.0, 1.0, 3.0});
  CHECK(odd->median == 3.0);
  const auto even = error_statistics({4.0, 0.0, 3.0, 1.0});
  CHECK(even->count == 4);
  CHECK(even->mean == 2.0);
  CHECK(even->median == 2.0);
  CHECK(even->max == 4.0);
  CHECK(even->rmse == Approx(std::sqrt(26.0 / 4.0)));
}

TEST_CASE("absolute errors are the distance and the angle between the poses", "[evaluation]") {
  const std::vector<PosePair> pairs{{0.0, planar_pose(0, 0, 10), planar_pose(3, 4, 40)},
                                    {1.0, planar_pose(1, 1, 175), planar_pose(1, 1, -175)}};
  const auto errors = pose_errors(pairs);
  REQUIRE(errors.size() == 2);
  CHECK(errors[0].translation_m == Approx(5.0));
  CHECK(errors[0].rotation_deg == Approx(30.0));
  CHECK(errors[1].translation_m == 0.0);
  CHECK(errors[1].rotation_deg == Approx(10.0));
  CHECK(translation_statistics(errors)->rmse == Approx(std::sqrt(12.5)));
  CHECK(rotation_statistics(errors)->rmse == Approx(std::sqrt(500.0)));
  CHECK_FALSE(translation_statistics({}));
}
