// SPDX-License-Identifier: MIT
// ORB-SLAM3's hooks that try the object poses of a key frame in other maps, on types of our own.
#include <algorithm>
#include <cstddef>
#include <vector>

#include <MergeFromPlaces.h>

#include "catch.hpp"
#include "semantic_slam/merge_scene.hpp"

namespace {

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
    CHECK(scene.map_points.size() == 100);
    CHECK(count_matches(scene.matches) == 100);

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
  hooks.places = {scene.place(0.51F), scene.place(), scene.place()};
  hooks.places[1].key_frame = &culled;
  CHECK(scene.begins(hooks, false));
  CHECK(hooks.tried == std::vector<int>{2});

  MergeScene refused(1.0);
  MergeHooks none;
  none.places = {refused.place()};
  CHECK_FALSE(refused.begins(none, false, 0));
  CHECK(none.tried == std::vector<int>{-1});
  CHECK(refused.matched == nullptr);
  CHECK_FALSE(refused.other.kept);

  MergeHooks silent;
  CHECK_FALSE(refused.begins(silent, false));
  CHECK(silent.tried.empty());

  refused.coincidences = 2;  // one is under way
  none.asked = 0;
  CHECK_FALSE(refused.begins(none, false, 4));
  CHECK(none.asked == 0);
}

TEST_CASE("a merge asks for eighty matches, as the host does", "[hooks]") {
  for (const std::size_t count : {79U, 80U}) {
    MergeScene scene(1.0);
    scene.other.points.resize(count);
    MergeHooks hooks;
    hooks.places = {scene.place()};
    CHECK(scene.begins(hooks, false) == (count == 80));
  }
}

TEST_CASE("a merge is made at once where three key frames beside agree", "[hooks]") {
  for (const std::size_t agreeing : {1U, 2U, 3U, 4U}) {
    CAPTURE(agreeing);
    MergeScene scene(1.0);
    MergeHooks hooks;
    hooks.places = {scene.place()};
    CHECK(scene.begins(hooks, false, agreeing));
    CHECK(scene.coincidences == static_cast<int>(std::min<std::size_t>(agreeing, 3)));
    CHECK(scene.merges == (agreeing >= 3));
  }
}

TEST_CASE("a key frame beside is asked where it is by its own pose", "[hooks]") {
  MergeScene scene(2.0);
  scene.beside[0].T_world_camera.t << 0.0F, 0.3F, 0.0F;  // in the present map's unit
  MergeHooks hooks;
  hooks.places = {scene.place()};
  CHECK(scene.begins(hooks, false));
  check_truth(scene, scene.Slw);
  // The last one that was asked stands where `now` does; the first one 0.3 beside.
  MergeScene first(2.0);
  first.beside.resize(1);
  first.now.neighbors = {&first.beside[0]};
  first.beside[0].T_world_camera.t << 0.0F, 0.3F, 0.0F;
  CHECK(first.begins(hooks, false));
  const g2o::Sim3 to_beside{Eigen::Quaterniond::Identity(), {0.0, -0.3, 0.0}, 1.0};
  const g2o::Sim3 truth = to_beside * first.now.S_camera_other;
  CHECK((first.given.t - truth.t).norm() < 1e-5);
  CHECK(first.given.s == Approx(0.5));
}

TEST_CASE("a place that is further off is looked for in a wide window", "[hooks]") {
  for (const float off : {0.19F, 0.3F, 0.49F, 0.51F}) {
    CAPTURE(off);
    MergeScene scene(1.0);
    MergeHooks hooks;
    hooks.places = {scene.place(off)};
    CHECK(scene.begins(hooks, false) == (off < 0.5F));
  }
}

TEST_CASE("a merge begins where two matches of three are wrong", "[hooks]") {
  for (const double scale : {1.0, 2.0}) {
    MergeScene scene(scale);
    scene.see(240, 3);
    MergeHooks hooks;
    hooks.places = {scene.place()};
    CHECK(scene.begins(hooks, false));
    check_truth(scene, scene.Slw);
  }
}

TEST_CASE("a merge is with the key frame that sees most of what is matched", "[hooks]") {
  MergeScene scene(1.0);
  MergedKeyFrame more;  // beside the place: it sees the upper seventy, the place the lower thirty
  more.T_world_camera.t << 0.5F, 0.2F, 1.0F;
  scene.other.neighbors = {&more};
  scene.other.points.clear();
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    MergedKeyFrame& seeing = i < 30 ? scene.other : more;
    seeing.points.push_back(&scene.points[i]);
    scene.points[i].seen_by = {&seeing};
  }
  MergeHooks hooks;
  hooks.places = {scene.place()};
  CHECK(scene.begins(hooks, false));
  CHECK(scene.matched == &more);
  CHECK(more.kept);
  CHECK_FALSE(scene.other.kept);
  check_truth(scene, scene.Slw);
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
  scene.see(60, 1);
  Lost hooks;
  hooks.places = {scene.place(0.0F)};
  ORB_SLAM3::Frame frame;
  frame.N = 60;
  CHECK(topobag_hooks::RelocalizeFromPlaces(hooks, frame));
  CHECK(hooks.tried == std::vector<int>{0});
  CHECK(frame.pose.q.angularDistance(scene.now.S_camera_other.q.cast<float>()) < 1e-5F);
  CHECK((frame.pose.t - scene.now.S_camera_other.t.cast<float>()).norm() < 1e-5F);
}
