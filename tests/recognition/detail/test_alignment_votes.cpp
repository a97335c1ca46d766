// SPDX-License-Identifier: MIT
#include <topobag/recognition/detail/alignment_votes.hpp>

#include <random>
#include <vector>

#include "catch.hpp"

using namespace topobag;

namespace {

using VoteError = Eigen::Matrix<double, 6, 1>;

VoteError normal_vote_error(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return VoteError::NullaryExpr([&] { return normal(random); });
}

Eigen::Isometry3d small_motion(const VoteError& xi) {
  const Eigen::Vector3d turn = xi.tail<3>();
  return Eigen::Translation3d(xi.head<3>()) * Eigen::AngleAxisd(turn.norm(), turn.normalized());
}

/// Nine places 8 m apart, in each a match that errs by centimetres and half a degree.
std::vector<detail::AlignmentVote> drawn_votes(std::mt19937& random, const Eigen::Isometry3d& T_a_b,
                                               std::uint64_t first_id = 0) {
  VoteError deviation;
  deviation << 0.02, 0.02, 0.05, 0.01, 0.01, 0.01;
  std::vector<detail::AlignmentVote> votes;
  for (std::uint64_t i = 0; i < 9; ++i) {
    const VoteError placed = normal_vote_error(random);
    const Eigen::Isometry3d T_a_candidate =
        Eigen::Translation3d(8.0 * static_cast<double>(i), 0.1 * placed(0), 0.1 * placed(1)) *
        Eigen::AngleAxisd(placed(2), Eigen::Vector3d::UnitY());
    const PoseWithCovariance<> T_candidate_query{
        small_motion(deviation.cwiseProduct(normal_vote_error(random))),
        deviation.cwiseAbs2().asDiagonal()};
    const Eigen::Isometry3d T_b_camera = T_a_b.inverse() * T_a_candidate;
    const auto T_a_camera = PoseWithCovariance<>{T_a_candidate} * T_candidate_query;
    votes.push_back({KeyframeId{first_id + i}, T_b_camera, T_a_camera.T,
                     T_a_camera * PoseWithCovariance<>{T_b_camera.inverse()}});
  }
  return votes;
}

Eigen::Isometry3d T_world_world() {
  return Eigen::Translation3d(5.0, -3.0, 0.4) * Eigen::AngleAxisd(0.9, Eigen::Vector3d::UnitY());
}

}  // namespace

TEST_CASE("the mean of votes errs as its covariance says: NEES of about six", "[recognition]") {
  std::mt19937 random(1);
  double sum = 0.0;
  const int rounds = 200;
  for (int round = 0; round < rounds; ++round) {
    const PoseWithCovariance<> mean = detail::mean_alignment(drawn_votes(random, T_world_world()));
    const VoteError xi = detail::logarithm(T_world_world() * mean.T.inverse());
    sum += xi.dot(mean.covariance.llt().solve(xi));
  }
  CHECK(sum / rounds > 4.0);  // the scatter only ever widens
  CHECK(sum / rounds < 6.5);
}

TEST_CASE("the largest consensus is that of the most key frames", "[recognition]") {
  std::mt19937 random(2);
  const auto true_votes = drawn_votes(random, T_world_world());
  auto votes = drawn_votes(random, Eigen::Isometry3d::Identity(), 100);
  votes.resize(4);
  votes.insert(votes.end(), true_votes.begin(), true_votes.end());
  const auto found = detail::consensus(votes, {});
  CHECK(detail::voters(found) == 9);
  CHECK(detail::places_of_voters(found) == 9);
  CHECK(found.front().id == KeyframeId{0});
}
