// SPDX-License-Identifier: MIT
// ORB-SLAM3's hooks that try the object poses of a key frame in other maps, on types of our own.
#include <cstddef>
#include <memory>
#include <vector>

#include <MergeFromPlaces.h>

#include "catch.hpp"

namespace {

using MergedKeyFrame = ORB_SLAM3::KeyFrame;
using MergedPoint = ORB_SLAM3::MapPoint;

struct MergeHooks {
  std::vector<topobag_hooks::Place<MergedKeyFrame>> places;
  std::vector<int> tried;
  int asked = 0;

  std::vector<topobag_hooks::Place<MergedKeyFrame>> MergePlaces() {
    ++asked;
    return places;
  }
  void MergePlacesTried(int accepted) { tried.push_back(accepted); }
};

/// A key frame, one of another map that sees the same, and how the two worlds' units go together.
struct MergeScene {
  explicit MergeScene(double scale_of_place) : scale(scale_of_place) {
    for (MergedPoint& point : points) other.points.push_back(&point);
    now.points.resize(points.size());
    other.T_world_camera.t << 0.5F, 0.0F, 1.0F;
    const Eigen::Quaterniond rotation(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
    const Eigen::Vector3d translation(0.2, -0.1, 0.4);  // in the other map's unit
    now.S_camera_other = {rotation, translation / scale, 1.0 / scale};
  }

  /// Of the truth, the camera that far off.
  topobag_hooks::Place<MergedKeyFrame> place(float off = 0.05F) {
    Eigen::Matrix4f T = Eigen::Matrix4f::Identity();
    T.topLeftCorner<3, 3>() = now.S_camera_other.q.toRotationMatrix().cast<float>();
    T.topRightCorner<3, 1>() = (scale * now.S_camera_other.t).cast<float>();
    T(0, 3) += off;
    topobag_hooks::Place<MergedKeyFrame> made{&other, {}, static_cast<float>(scale)};
    Eigen::Map<Eigen::Matrix<float, 4, 4, Eigen::RowMajor>>(made.Tcw.data()) = T;
    return made;
  }

  /// Whether a merge has begun.
  bool begins(MergeHooks& hooks, bool fixed_scale, bool host_agrees = true) {
    topobag_hooks::MergeFromPlaces(hooks, &now, fixed_scale, {matched, last, Slw, coincidences},
                                   [&](MergedKeyFrame*, g2o::Sim3& Scw) {
                                     given = Scw;
                                     return host_agrees;
                                   });
    return coincidences == 1;
  }

  const double scale;
  std::vector<MergedPoint> points = std::vector<MergedPoint>(30);
  MergedKeyFrame now, other;
  MergedKeyFrame *matched = nullptr, *last = nullptr;
  g2o::Sim3 Slw, given;
  int coincidences = 0;
};

void check_truth(const MergeScene& scene, const g2o::Sim3& S) {
  CHECK(S.s == Approx(scene.now.S_camera_other.s).epsilon(1e-6));
  CHECK((S.t - scene.now.S_camera_other.t).norm() < 1e-5);
  CHECK(S.q.angularDistance(scene.now.S_camera_other.q) < 1e-5);
}

}  // namespace

TEST_CASE("a merge begins with the scale of its place", "[hooks]") {
  for (const double scale : {0.5, 1.0, 2.0}) {
    CAPTURE(scale);
    MergeScene scene(scale);
    MergeHooks hooks;
    hooks.places = {scene.place()};
    CHECK(scene.begins(hooks, false));
    CHECK(hooks.tried == std::vector<int>{0});
    check_truth(scene, scene.given);
    check_truth(scene, scene.Slw);
    CHECK(scene.matched == &scene.other);
    CHECK(scene.last == &scene.now);
    CHECK(scene.other.kept);

    // With a scale of one it is found only where that is right.
    MergeScene unscaled(scale);
    MergeHooks plain;
    plain.places = {unscaled.place()};
    plain.places[0].scale = 1.0F;
    CHECK(unscaled.begins(plain, false) == (scale == 1.0));
  }
}

TEST_CASE("a merge's scale is one where the host fixes it", "[hooks]") {
  MergeScene scene(1.0);
  MergeHooks hooks;
  hooks.places = {scene.place()};
  hooks.places[0].scale = 0.97F;
  CHECK(scene.begins(hooks, true));
  CHECK(scene.given.s == 1.0);
}

TEST_CASE("a merge begins at the first place that stands the host's test", "[hooks]") {
  MergeScene scene(1.0);
  MergedKeyFrame culled;
  culled.bad = true;
  MergeHooks hooks;
  hooks.places = {scene.place(0.5F), scene.place(), scene.place()};
  hooks.places[1].key_frame = &culled;
  CHECK(scene.begins(hooks, false));
  CHECK(hooks.tried == std::vector<int>{2});

  MergeScene refused(1.0);
  MergeHooks none;
  none.places = {refused.place()};
  CHECK_FALSE(refused.begins(none, false, false));
  CHECK(none.tried == std::vector<int>{-1});
  CHECK(refused.matched == nullptr);
  CHECK_FALSE(refused.other.kept);

  MergeHooks silent;
  CHECK_FALSE(refused.begins(silent, false));
  CHECK(silent.tried.empty());

  refused.coincidences = 2;  // one is under way
  none.asked = 0;
  CHECK_FALSE(refused.begins(none, false));
  CHECK(none.asked == 0);
}

TEST_CASE("a merge asks for twenty matches", "[hooks]") {
  for (const std::size_t count : {19U, 20U}) {
    MergeScene scene(1.0);
    scene.other.points.resize(count);
    MergeHooks hooks;
    hooks.places = {scene.place()};
    CHECK(scene.begins(hooks, false) == (count == 20));
  }
}

TEST_CASE("ORB-SLAM3: a lost frame gets the pose of its place", "[hooks]") {
  struct Lost {
    std::vector<topobag_hooks::Place<MergedKeyFrame>> places;
    std::vector<int> tried;
    std::vector<topobag_hooks::Place<MergedKeyFrame>> RelocalizationPlaces() const {
      return places;
    }
    void PlacesTried(int accepted) { tried.push_back(accepted); }
  };
  MergeScene scene(1.0);
  scene.points.resize(60);
  scene.other.points.clear();
  for (MergedPoint& point : scene.points) scene.other.points.push_back(&point);
  Lost hooks;
  hooks.places = {scene.place(0.0F)};
  ORB_SLAM3::Frame frame;
  frame.N = 60;
  CHECK(topobag_hooks::RelocalizeFromPlaces(hooks, frame));
  CHECK(hooks.tried == std::vector<int>{0});
  CHECK(frame.pose.q.angularDistance(scene.now.S_camera_other.q.cast<float>()) < 1e-5F);
  CHECK((frame.pose.t - scene.now.S_camera_other.t.cast<float>()).norm() < 1e-5F);
}
