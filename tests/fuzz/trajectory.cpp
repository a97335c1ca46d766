// SPDX-License-Identifier: MIT
// Text that claims to be a trajectory, a matrix or a list of scores: refused with an Error, or
// read.
#include <cmath>
#include <sstream>

#include <topobag/evaluation/kitti_trajectory.hpp>
#include <topobag/evaluation/npy_matrix.hpp>
#include <topobag/evaluation/openloris_trajectory.hpp>
#include <topobag/evaluation/score_csv.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>

#include "fuzz/fuzz_input.hpp"

namespace {

void check(const topobag::Trajectory& trajectory) {
  for (const auto& pose : trajectory) {
    require(std::isfinite(pose.stamp), "a stamp is finite");
    require(pose.T_world_body.matrix().allFinite(), "a pose is finite");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  const int kind = input.below(5);
  std::istringstream stream(input.rest());
  try {
    switch (kind) {
      case 0:
        check(topobag::read_tum(stream, "it"));
        break;
      case 1:
        check(topobag::read_kitti(stream, "it"));
        break;
      case 2:
        for (const auto& [id, trajectory] : topobag::read_openloris(stream, "it").sequences) {
          check(trajectory);
        }
        break;
      case 3:
        topobag::read_score_csv(stream, "it");
        break;
      default:
        topobag::read_npy(stream, "it");
    }
  } catch (const topobag::Error&) {
  }
  return 0;
}
