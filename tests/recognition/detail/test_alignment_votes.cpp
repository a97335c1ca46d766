// SPDX-License-Identifier: MIT
#include <topobag/recognition/detail/alignment_votes.hpp>

#include <random>
#include <vector>

#include "catch.hpp"
#include "recognition/drawn_sim3.hpp"

using namespace topobag;

namespace {

using VoteError = Eigen::Matrix<double, 6, 1>;
using RigidVotes = std::vector<detail::AlignmentVote<PoseWithCovariance<>>>;
using ScaledVotes = std::vector<detail::AlignmentVote<detail::Sim3WithCovariance>>;

VoteError normal_vote_error(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return VoteError::NullaryExpr([&] { return normal(random); });
}

Eigen::Isometry3d small_motion(const VoteError& xi) {
  const Eigen::Vector3d turn = xi.tail<3>();
  return Eigen::Translation3d(xi.head<3>()) * Eigen::AngleAxisd(turn.norm(), turn.normalized());
}

/// Nine places 8 m apart, in each a match that errs by centimetres and half a degree.
RigidVotes drawn_votes(std::mt19937& random, const Eigen::Isometry3d& T_a_b,
                       std::uint64_t first_id = 0) {
  VoteError deviation;
  deviation << 0.02, 0.02, 0.05, 0.01, 0.01, 0.01;
  RigidVotes votes;
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

/// The same where map b's unit is not known: the objects, 3 m ahead, tell it to 3 %, and where the
/// scale errs the camera errs along with it.
ScaledVotes drawn_scaled_votes(std::mt19937& random, const detail::Sim3WithCovariance& a_b,
                               std::uint64_t first_id = 0) {
  VoteError deviation, lever;
  deviation << 0.02, 0.02, 0.05, 0.01, 0.01, 0.01;
  lever << 0.0, 0.0, -3.0, 0.0, 0.0, 0.0;
  const double of_scale = 0.03;
  ScaledVotes votes;
  for (std::uint64_t i = 0; i < 9; ++i) {
    const VoteError placed = normal_vote_error(random);
    detail::Sim3WithCovariance a_candidate, camera_b;
    a_candidate.T = Eigen::Translation3d(8.0 * static_cast<double>(i), placed(0), placed(1)) *
                    Eigen::AngleAxisd(placed(2), Eigen::Vector3d::UnitY());
    const double lambda = of_scale * normal_vote_error(random)(0);
    const VoteError xi = deviation.cwiseProduct(normal_vote_error(random)) + lambda * lever;
    RelativePose pose;
    pose.T_candidate_query = small_motion(xi).inverse();
    pose.scale = a_b.scale * std::exp(-lambda);
    pose.scale_deviation = of_scale * pose.scale;
    pose.covariance = deviation.cwiseAbs2().asDiagonal();
    pose.covariance += of_scale * of_scale * lever * lever.transpose();
    pose.scale_covariance = of_scale * of_scale * lever;
    Eigen::Isometry3d T_b_camera = a_b.T.inverse() * a_candidate.T;
    T_b_camera.translation() /= a_b.scale;
    camera_b.T = T_b_camera.inverse();
    const auto a_camera = a_candidate * detail::Sim3WithCovariance::of(pose);
    votes.push_back({KeyframeId{first_id + i}, T_b_camera, a_camera.T, a_camera * camera_b});
  }
  return votes;
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
  CHECK(detail::places_of_voters(found, 1.0) == 9);
  CHECK(found.front().id == KeyframeId{0});
}

TEST_CASE("the mean of votes with a scale errs as it says: NEES of about seven", "[recognition]") {
  std::mt19937 random(2240);
  const int rounds = 200;
  double sum = 0.0, of_scale = 0.0, deviation = 0.0;
  for (int round = 0; round < rounds; ++round) {
    detail::Sim3WithCovariance truth = drawn_sim3(random);
    truth.T = T_world_world();
    const auto mean = detail::mean_alignment(drawn_scaled_votes(random, truth));
    const auto zeta = detail::error_between(truth, mean);
    sum += zeta.dot(mean.covariance.llt().solve(zeta)) / rounds;
    of_scale += zeta(6) * zeta(6) / mean.covariance(6, 6) / rounds;
    deviation += std::sqrt(mean.covariance(6, 6)) / rounds;
    CHECK(detail::places_of_voters(drawn_scaled_votes(random, truth), truth.scale) == 9);
  }
  CHECK(sum > 4.7);  // the scatter only ever widens
  CHECK(sum < 7.6);
  CHECK(of_scale > 0.6);
  CHECK(of_scale < 1.25);
  // How far the cameras stand apart says more than each match does: 3 % / √9.
  CHECK(deviation < 0.005);
}

TEST_CASE("votes of another scale agree on nothing, wherever they put the camera",
          "[recognition]") {
  std::mt19937 random(2241);
  detail::Sim3WithCovariance truth{T_world_world(), 0.7};
  const auto votes = drawn_scaled_votes(random, truth);
  const auto found = detail::consensus(votes, {});
  CHECK(detail::voters(found) >= 8);
  const auto mean = detail::mean_alignment(found);
  for (detail::AlignmentVote<detail::Sim3WithCovariance> vote : votes) {
    CHECK(detail::agrees(mean, vote, {}));
    vote.a_b.scale *= 1.2;  // its camera stays
    CHECK_FALSE(detail::agrees(mean, vote, {}));
  }
}

namespace {

/// Matches that are all false: any pose and any scale, which is known to `of_scale`.
template <typename Motion>
std::vector<detail::AlignmentVote<Motion>> false_votes(std::mt19937& random, std::uint64_t count,
                                                       double of_scale) {
  std::uniform_real_distribution<double> metres(-5.0, 5.0), turn(-3.1, 3.1), octaves(-2.0, 2.0);
  const auto anywhere = [&] {
    const double x = metres(random), y = 0.04 * metres(random), z = metres(random);
    return Eigen::Isometry3d(Eigen::Translation3d(x, y, z) *
                             Eigen::AngleAxisd(turn(random), Eigen::Vector3d::UnitY()));
  };
  VoteError deviation, lever;
  deviation << 0.03, 0.03, 0.05, 0.02, 0.02, 0.02;
  lever << 0.0, 0.0, -3.0, 0.0, 0.0, 0.0;
  std::vector<detail::AlignmentVote<Motion>> votes;
  for (std::uint64_t i = 0; i < count; ++i) {
    Motion a_camera, camera_b;
    a_camera.T = anywhere();
    Eigen::Isometry3d T_b_camera = anywhere();
    RelativePose pose;
    pose.covariance = deviation.cwiseAbs2().asDiagonal();
    const double scale = std::exp2(octaves(random));
    if (detail::unknowns_v<Motion> == 7) {
      pose.scale = scale;
      pose.scale_deviation = of_scale * scale;
      pose.covariance += of_scale * of_scale * lever * lever.transpose();
      pose.scale_covariance = of_scale * of_scale * lever;
      T_b_camera.translation() /= scale;
    }
    camera_b.T = T_b_camera.inverse();
    votes.push_back({KeyframeId{i}, T_b_camera, a_camera.T,
                     a_camera * detail::motion_of<Motion>(pose) * camera_b});
  }
  return votes;
}

/// How often three or more of 25 false votes agree, in 100 draws.
template <typename Motion>
int chance_agreements(double of_scale) {
  std::mt19937 random(2242);
  int agreed = 0;
  for (int round = 0; round < 100; ++round) {
    const auto votes = false_votes<Motion>(random, 25, of_scale);
    agreed += detail::voters(detail::consensus(votes, {})) >= 3 ? 1 : 0;
  }
  return agreed;
}

}  // namespace

TEST_CASE("false votes agree no more often for not knowing the scale, however little they do",
          "[recognition]") {
  const int known = chance_agreements<PoseWithCovariance<>>(0.0);
  CHECK(known >= 3);
  CHECK(known <= 30);
  for (const double of_scale : {0.03, 0.1, 0.2}) {
    CAPTURE(of_scale);
    CHECK(chance_agreements<detail::Sim3WithCovariance>(of_scale) <= known);
  }
}
