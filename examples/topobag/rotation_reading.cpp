// SPDX-License-Identifier: MIT
#include "rotation_reading.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "input_error.hpp"
#include "pose_reading.hpp"

namespace program {
namespace {

constexpr double turn_degree = 0.017453292519943295;

/// Two matched poses that the truth turns between.
using Turn = std::pair<const topobag::PosePair*, const topobag::PosePair*>;

std::vector<Turn> turns_of(const std::map<int, topobag::SequenceScore>& scores) {
  const double least = 10.0 * turn_degree;  // clear of a good estimate's errors
  const std::size_t enough = 2000;
  std::vector<Turn> turns;
  for (const auto& [number, score] : scores) {
    const topobag::PosePair* from = nullptr;
    for (const topobag::PosePair& pair : score.pairs) {
      if (turns.size() >= enough) return turns;
      if (from == nullptr) from = &pair;
      const Eigen::Quaterniond before(from->T_true.linear()), after(pair.T_true.linear());
      if (before.angularDistance(after) < least) continue;
      turns.push_back({from, &pair});
      from = &pair;
    }
  }
  return turns;
}

Eigen::Quaterniond turn(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  return Eigen::Quaterniond((from.linear().transpose() * to.linear()).eval());
}

/// By how much the turns of both differ, in the middle of all, degrees.
template <typename ReadTrue, typename ReadEstimate>
double middle_difference(const std::vector<Turn>& turns, const ReadTrue& read_true,
                         const ReadEstimate& read_estimate) {
  std::vector<double> differences;
  for (const auto& [from, to] : turns) {
    const Eigen::Quaterniond truth = turn(read_true(from->T_true), read_true(to->T_true));
    const Eigen::Quaterniond estimate =
        turn(read_estimate(from->T_estimate), read_estimate(to->T_estimate));
    differences.push_back(truth.angularDistance(estimate) / turn_degree);
  }
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return *middle;
}

}  // namespace

void require_same_rotations(const std::string& groundtruth, const std::string& estimate,
                            const std::map<int, topobag::SequenceScore>& scores) {
  const std::vector<Turn> turns = turns_of(scores);
  const std::size_t few = 10;
  if (turns.size() < few) return;
  const auto as_told = [](const Eigen::Isometry3d& pose) { return pose; };
  const auto inverse = [](const Eigen::Isometry3d& pose) { return pose.inverse(); };
  const double as_read = middle_difference(turns, as_told, as_told);
  const auto require = [&](double otherwise, const std::string& file, const char* reading,
                           const char* remedy) {
    const double least = 5.0, times = 3.0;  // degrees; as far
    if (as_read < least || as_read < times * otherwise) return;
    std::ostringstream why;
    why.precision(2);
    why << "its rotations do not go with those of the other file: in the median of " << turns.size()
        << " turns they differ by " << as_read << "°, and by " << otherwise << "° when it is read "
        << reading << "; " << remedy;
    throw InputError(file, why.str());
  };
  const char* const w_first = "with the quaternion's w first";
  const char* const w_last = "write it with w last, qx qy qz qw";
  require(middle_difference(turns, as_told, read_w_first), estimate, w_first, w_last);
  require(middle_difference(turns, read_w_first, as_told), groundtruth, w_first, w_last);
  require(middle_difference(turns, as_told, inverse), estimate, "as world to camera",
          "one of the two holds the inverse of poses in the world; write these");
}

}  // namespace program
