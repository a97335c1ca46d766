// SPDX-License-Identifier: MIT
// Poses that are read otherwise than they were written: told by what the frames see.
#include "pose_reading.hpp"

#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "error_text.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

namespace pr = program;

pr::KeyframeOptions reading_options() {
  pr::KeyframeOptions options;
  options.camera = {500.0, 500.0, 320.0, 240.0, 640, 480};
  return options;
}

Eigen::Isometry3d drawn_camera(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() =
      Eigen::Quaterniond(2.0 + normal(random), normal(random), normal(random), normal(random))
          .normalized()
          .toRotationMatrix();
  T.translation() << normal(random), normal(random), normal(random);
  return T;
}

/// Frames half a second apart in which a laptop, a tv and a keyboard stand still, 1 cm of noise.
std::vector<pr::FrameRow> drawn_frames(std::uint32_t seed, std::size_t count) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.01);
  const auto catalog = topobag::ClassCatalog::coco80();
  const std::vector<topobag::ClassId> labels{catalog.at("laptop"), catalog.at("tv"),
                                             catalog.at("keyboard")};
  const pr::KeyframeOptions options = reading_options();
  std::vector<pr::FrameRow> frames;
  while (frames.size() < count) {
    pr::FrameRow frame;
    frame.timestamp = 0.5 * static_cast<double>(frames.size());
    frame.T_world_camera = drawn_camera(random);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const Eigen::Vector3d world(3.0 * static_cast<double>(i), 8.0, 1.0);
      Eigen::Vector3d p = frame.T_world_camera->inverse() * world;
      for (double& x : p) x += noise(random);
      if (p.z() < 0.3) continue;
      const Eigen::Vector2d pixel(500.0 * p.x() / p.z() + 320.0, 500.0 * p.y() / p.z() + 240.0);
      frame.detections.push_back({topobag::box_around(pixel, 20.0, 20.0), labels[i], 0.9});
      frame.detections.back().z = p.z();
    }
    frames.push_back(frame);
  }
  return frames;
}

std::string said_of_poses(const std::vector<pr::FrameRow>& frames) {
  return error_text([&] { pr::require_pose_reading("poses.txt", frames, reading_options()); });
}

/// As a file with w first is read with w last.
Eigen::Isometry3d misread(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  Eigen::Isometry3d other = pose;
  other.linear() = Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()).toRotationMatrix();
  return other;
}

}  // namespace

TEST_CASE("poses that are read otherwise than written are refused", "[examples][regression]") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const std::vector<pr::FrameRow> right = drawn_frames(seed, 120);
    CHECK(said_of_poses(right) == "nothing was thrown");
    std::vector<pr::FrameRow> frames = right;
    for (auto& frame : frames) frame.T_world_camera = misread(*frame.T_world_camera);
    CHECK(pr::read_w_first(*frames[0].T_world_camera).isApprox(*right[0].T_world_camera, 1e-9));
    CHECK(said_of_poses(frames).find("m when it is read with the quaternion's w first; write the "
                                     "quaternion with w last, qx qy qz qw") != std::string::npos);
    frames = right;
    for (auto& frame : frames) frame.T_world_camera = frame.T_world_camera->inverse();
    CHECK(said_of_poses(frames).find("read as world to camera; write the camera's pose in the "
                                     "world, the inverse") != std::string::npos);
    for (auto& frame : frames) frame.T_world_camera = misread(*frame.T_world_camera);
    CHECK(said_of_poses(frames).find("read as world to camera with the quaternion's w first") !=
          std::string::npos);
  }
  std::vector<pr::FrameRow> few = drawn_frames(1, 6);
  for (auto& frame : few) frame.T_world_camera = misread(*frame.T_world_camera);
  CHECK(said_of_poses(few) == "nothing was thrown");
}

TEST_CASE("poses that are all the same while what is seen moves are told",
          "[examples][regression]") {
  std::vector<pr::FrameRow> frames = drawn_frames(3, 120);
  CHECK(pr::same_poses_text(frames, reading_options()).empty());
  for (auto& frame : frames) frame.T_world_camera = Eigen::Isometry3d::Identity();
  const std::string told = pr::same_poses_text(frames, reading_options());
  CHECK(told.find("all poses are the same, and what is seen moves by ") == 0);
  CHECK(told.find("leave poses empty where they are not known") != std::string::npos);
  for (auto& frame : frames) frame.detections = frames[0].detections;
  CHECK(pr::same_poses_text(frames, reading_options()).empty());  // the camera stands
}

TEST_CASE("poses with w first are refused by what reads a table", "[examples][regression]") {
  const ScratchFolder folder;
  program::CsvReader csv(sample_query + ".frames.csv");
  std::string frames = "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw\n";
  while (csv.next()) {
    for (const std::size_t column : {0u, 1u, 2u, 3u, 4u, 5u, 9u, 6u, 7u, 8u}) {
      frames += std::string(csv.text(column)) + (column == 8 ? "\n" : ",");
    }
  }
  folder.write("w.frames.csv", frames);
  folder.write("w.nodes.csv", program::read_file(sample_query + ".nodes.csv"));
  const std::string set = folder.path("w");
  for (const std::string& command :
       {"localize --map " + sample_map + " --query " + set,
        "map --out " + folder.path("m.bag") + " --nodes " + set, "loops --nodes " + set}) {
    CHECK(refusal(command + " --camera 517.3,516.5,318.6,255.3")
              .find(set + ".frames.csv: its poses do not bring together what the frames see") == 0);
  }
}
