// SPDX-License-Identifier: MIT
// ORB-SLAM3's hook: the pose of a lost frame by RANSAC among matches that are mostly wrong.
#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <RelocalizeFromPlaces.h>

#include "catch.hpp"

namespace {

/// A frame whose features see points of a box before it, some of the matches wrong.
class MatchedFrame {
 public:
  MatchedFrame(std::size_t right, std::size_t wrong, unsigned seed) : points_(right + wrong) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> in(-1.0F, 1.0F);
    const auto draw = [&] {  // the same under every compiler
      const float x = in(random), y = in(random), z = in(random);
      return Eigen::Vector3f(x, y, z);
    };
    const Eigen::Vector3f axis = draw().normalized(), t = draw();
    truth = {Eigen::Quaternionf(Eigen::AngleAxisf(0.5F * in(random), axis)), t};
    frame.mpCamera = &camera_;
    frame.N = static_cast<int>(points_.size()) + 1;
    frame.mvKeysUn.emplace_back(cv::Point2f(0.0F, 0.0F), 31.0F);  // one without a match
    frame.mvpMapPoints.push_back(nullptr);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Eigen::Vector3f seen = Eigen::Vector3f(0.0F, 0.0F, 3.0F) + draw();
      points_[i].position = truth.q.conjugate() * (seen - truth.t);
      Eigen::Vector2f pixel = camera_.focal / seen.z() * seen.head<2>();
      if (i >= right) pixel = 250.0F * draw().head<2>();
      frame.mvKeysUn.emplace_back(cv::Point2f(pixel.x(), pixel.y()), 31.0F);
      frame.mvpMapPoints.push_back(&points_[i]);
    }
  }

  Sophus::SE3f truth;
  ORB_SLAM3::Frame frame;

 private:
  ORB_SLAM3::GeometricCamera camera_;
  std::vector<ORB_SLAM3::MapPoint> points_;
};

}  // namespace

TEST_CASE("ORB-SLAM3: where two matches of three are wrong, RANSAC finds the pose", "[hooks]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    MatchedFrame matched(100, 200, seed);
    topobag_hooks::OrbSlam3::ApplyRansac(matched.frame);
    CHECK(matched.frame.pose.q.angularDistance(matched.truth.q) < 0.01F);
    CHECK((matched.frame.pose.t - matched.truth.t).norm() < 0.02F);
    const auto& kept = matched.frame.mvpMapPoints;
    CHECK(std::count(kept.begin() + 1, kept.begin() + 101, nullptr) < 5);
    CHECK(std::count(kept.begin() + 101, kept.end(), nullptr) > 190);
  }
}

TEST_CASE("ORB-SLAM3: pose and matches stay where RANSAC finds none", "[hooks]") {
  for (const auto& [right, wrong] :
       {std::pair<std::size_t, std::size_t>{9, 0}, {20, 280}, {0, 60}, {0, 0}}) {
    CAPTURE(right, wrong);
    MatchedFrame matched(right, wrong, 3);
    const auto before = matched.frame.mvpMapPoints;
    topobag_hooks::OrbSlam3::ApplyRansac(matched.frame);
    CHECK(matched.frame.pose.t == Eigen::Vector3f::Zero());
    CHECK(matched.frame.pose.q.coeffs() == Eigen::Quaternionf::Identity().coeffs());
    CHECK(matched.frame.mvpMapPoints == before);
  }
}
