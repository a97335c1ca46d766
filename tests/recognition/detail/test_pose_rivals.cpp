// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>

#include <Eigen/Geometry>

#include <topobag/recognition/detail/pose_rivals.hpp>

#include "catch.hpp"
#include "recognition/synthetic_room.hpp"

using namespace topobag;

namespace {

/// A pose that matches the first `objects` of the query, each with its like.
RelativePose matching_first(std::size_t objects, const Eigen::Isometry3d& T_candidate_query) {
  RelativePose pose;
  pose.T_candidate_query = T_candidate_query;
  for (std::size_t i = 0; i < objects; ++i) {
    pose.inliers.push_back({node_index(i), node_index(i)});
  }
  return pose;
}

}  // namespace

TEST_CASE("objects are put elsewhere that another pose moves, or does not match", "[recognition]") {
  const TopologyGraph<> query = SyntheticRoom(4, 9, 4).seen_from(Eigen::Isometry3d::Identity());
  std::mt19937 random(5);
  for (std::size_t objects = 3; objects <= 9; ++objects) {
    const Eigen::Isometry3d T = random_camera(random);
    const RelativePose pose = matching_first(objects, T);
    CHECK(detail::objects_put_elsewhere(query, pose, pose, T) == 0);
    const Eigen::Isometry3d moved = Eigen::Translation3d(1.0, 0.0, 0.0) * T;
    CHECK(detail::objects_put_elsewhere(query, pose, pose, moved) == objects);
    CHECK(detail::objects_put_elsewhere(query, pose, matching_first(2, T), T) == objects - 2);
    // Without a frame that both share, all are.
    CHECK(detail::objects_put_elsewhere(query, pose, pose, std::nullopt) == objects);
    // One turned about an object leaves that where it is.
    const Eigen::Vector3d middle = T * *query.nodes()[0].position;
    const Eigen::Isometry3d turned = Eigen::Translation3d(middle) *
                                     Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitZ()) *
                                     Eigen::Translation3d(-middle) * T;
    CHECK(detail::objects_put_elsewhere(query, pose, pose, turned) < objects);
  }
}

TEST_CASE("the lead asked for over a place believed by itself is so many deviations of noise",
          "[recognition]") {
  DecisionOptions options;
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  for (const std::size_t objects : {3U, 6U, 12U}) {
    // Two fits of as many objects to measurements with their own noise, in decades.
    const auto support = [&] {
      double squares = 0.0;
      for (std::size_t i = 0; i < 3 * objects; ++i) squares += std::pow(normal(random), 2);
      return -0.5 * squares / std::log(10.0);
    };
    const int rounds = 4000;
    double variance = 0.0;
    for (int i = 0; i < rounds; ++i) variance += std::pow(support() - support(), 2) / rounds;
    options.min_lead = 0.0;
    options.lead_deviations = 1.0;
    CHECK(detail::lead_to_ask(objects, 5.0, options) == Approx(std::sqrt(variance)).epsilon(0.05));
  }
}

TEST_CASE("the lead asked for grows with how far the rival is believed, and with the objects",
          "[recognition]") {
  const DecisionOptions options;
  const double full = options.rival_support;
  CHECK(detail::lead_to_ask(8, -1.0, options) == options.min_lead);
  CHECK(detail::lead_to_ask(0, full, options) == options.min_lead);
  const double half = detail::lead_to_ask(8, 0.5 * full, options) - options.min_lead;
  const double whole = detail::lead_to_ask(8, full, options) - options.min_lead;
  CHECK(half > 0.0);
  CHECK(whole == Approx(2.0 * half));
  CHECK(detail::lead_to_ask(8, 9.0 * full, options) - options.min_lead == Approx(whole));
  CHECK(detail::lead_to_ask(32, full, options) - options.min_lead == Approx(2.0 * whole));
}
