// SPDX-License-Identifier: MIT
#include <topobag/evaluation/loop_verdicts.hpp>

#include "catch.hpp"
#include "evaluation/random_poses.hpp"

using namespace topobag;
using topobag_tests::planar_pose;

TEST_CASE("a loop is judged by its relative pose, wherever the two cameras are", "[evaluation]") {
  PlaceProtocol protocol;
  protocol.distance_m = 1.0;
  const PlaceTruth truth(protocol, {{0.0, planar_pose(2, 1, 180)}, {1.0, planar_pose(0, 0, 0)}});
  // Query 0 is 2.2 m away and looks back: no positive, and yet a correct loop.
  CHECK(truth.relation(0, 1) == PairRelation::negative);
  LoopVerdicts verdicts;
  CHECK_FALSE(verdicts.precision());
  verdicts.add(judge_loop(truth, 0, 1, planar_pose(2, 1, 180)));
  verdicts.add(judge_loop(truth, 0, 1, planar_pose(2.2, 1, 170)));
  verdicts.add(judge_loop(truth, 0, 1, planar_pose(2.5, 1, 170)));
  verdicts.add(judge_loop(truth, 1, 0, planar_pose(2, 1, 180)));
  verdicts.add(judge_loop(truth, 1, 0, planar_pose(0, 0, 0)));
  CHECK(verdicts.correct == 3);
  CHECK(verdicts.imprecise == 1);
  CHECK(verdicts.wrong == 1);
  CHECK(*verdicts.precision() == Approx(0.6));
  CHECK(judge_loop(truth, 0, 1, planar_pose(2.5, 1, 170), {1.0, 20.0, 2.0, 45.0}) ==
        PoseVerdict::correct);
}
