// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "catch.hpp"
#include "keyframe_graphs.hpp"
#include "sample.hpp"
#include "table_gravity.hpp"

using namespace program;

namespace {

constexpr double degree = 0.017453292519943295;

/// Frames whose cameras stand and look anyhow.
NodeTable turned_frames(std::size_t count) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  NodeTable table;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
    FrameRow frame;
    frame.T_world_camera = Eigen::Translation3d(normal(random), 0.0, 1.0) * q.normalized();
    table.frames.push_back(frame);
  }
  return table;
}

NodeTable told(NodeTable table, const Eigen::Vector3d& up, double noise, std::uint32_t seed = 1,
               std::uint32_t stream = 0) {
  apply({up, noise}, Draws{seed, stream, 1}, table);
  return table;
}

}  // namespace

TEST_CASE("without an axis that points up no frame knows which way is down",
          "[examples][gravity]") {
  NodeTable table = turned_frames(3);
  apply(TableGravity{}, Draws{1, 0, 1}, table);
  for (const FrameRow& frame : table.frames) CHECK_FALSE(frame.gravity);
}

TEST_CASE("down is against the world's up, in the camera's frame", "[examples][gravity]") {
  for (const Eigen::Vector3d& up :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, -2, 0), Eigen::Vector3d(1e200, 1e200, 0)}) {
    const NodeTable table = told(turned_frames(50), up, 0.0);
    for (const FrameRow& frame : table.frames) {
      REQUIRE(frame.gravity);
      const Eigen::Vector3d in_world = frame.T_world_camera->linear() * frame.gravity->down;
      CHECK(in_world.isApprox(-up.stableNormalized(), 1e-12));
      CHECK(frame.gravity->deviation == Approx(0.1 * degree));
    }
  }
}

TEST_CASE("of a pose nothing else is told", "[examples][gravity]") {
  NodeTable table = turned_frames(20), moved = table;
  const Eigen::Isometry3d elsewhere =
      Eigen::Translation3d(3.0, -20.0, 1.0) * Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ());
  for (FrameRow& frame : moved.frames) frame.T_world_camera = elsewhere * *frame.T_world_camera;
  table = told(table, {0, 0, 1}, 2.0);
  moved = told(moved, {0, 0, 1}, 2.0);
  for (std::size_t i = 0; i < table.frames.size(); ++i) {
    CHECK(table.frames[i].gravity->down.isApprox(moved.frames[i].gravity->down, 1e-9));
  }
}

TEST_CASE("the noise is normal about both horizontal axes, and is stated", "[examples][gravity]") {
  const NodeTable table = told(turned_frames(20000), {0, 0, 1}, 3.0);
  double sum_x = 0.0, sum_y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  for (const FrameRow& frame : table.frames) {
    CHECK(frame.gravity->deviation == Approx(3.0 * degree));
    CHECK(frame.gravity->down.norm() == Approx(1.0));
    const Eigen::Vector3d exact = -frame.T_world_camera->linear().row(2).transpose();
    const Eigen::Vector3d u = exact.unitOrthogonal(), v = exact.cross(u);
    const double x = frame.gravity->down.dot(u) / (3.0 * degree);
    const double y = frame.gravity->down.dot(v) / (3.0 * degree);
    sum_x += x, sum_y += y, xx += x * x, yy += y * y, xy += x * y;
  }
  for (const double mean : {sum_x / 20000, sum_y / 20000, xy / 20000}) CHECK(std::abs(mean) < 0.03);
  for (const double square : {xx / 20000, yy / 20000}) CHECK(std::abs(square - 1.0) < 0.04);
}

TEST_CASE("one seed gives one noise, whichever frames have poses", "[examples][gravity]") {
  const NodeTable all = told(turned_frames(10), {0, 0, 1}, 1.0);
  NodeTable some = turned_frames(10);
  some.frames[3].T_world_camera.reset();
  some = told(some, {0, 0, 1}, 1.0);
  CHECK_FALSE(some.frames[3].gravity);
  CHECK(some.frames[9].gravity->down == all.frames[9].gravity->down);
  CHECK(told(turned_frames(10), {0, 0, 1}, 1.0, 2).frames[9].gravity->down !=
        all.frames[9].gravity->down);
  CHECK(told(turned_frames(10), {0, 0, 1}, 1.0, 1, 1).frames[9].gravity->down !=
        all.frames[9].gravity->down);
}

TEST_CASE("graphs of key frames know what their frames do", "[examples][gravity]") {
  KeyframeOptions options;
  options.camera = {517.3, 516.5, 318.6, 255.3, 640, 480};
  options.gravity.world_up = Eigen::Vector3d::UnitZ();
  for (const double window : {0.0, 3.0}) {
    options.window = window;
    options.gravity.noise = 0.0;
    for (const Keyframe& keyframe : read_keyframes(sample_map, options)) {
      REQUIRE(keyframe.graph.gravity());
      const Eigen::Vector3d up =
          keyframe.T_world_camera->linear() * -keyframe.graph.gravity()->down;
      CHECK(up.isApprox(Eigen::Vector3d::UnitZ(), 1e-9));
      CHECK(keyframe.graph.gravity()->deviation <= Approx(0.1 * degree));
    }
    options.gravity.world_up.reset();
    for (const Keyframe& keyframe : read_keyframes(sample_map, options)) {
      CHECK_FALSE(keyframe.graph.gravity());
    }
    options.gravity.world_up = Eigen::Vector3d::UnitZ();
  }
}
