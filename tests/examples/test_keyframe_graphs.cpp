// SPDX-License-Identifier: MIT
#include <vector>

#include <topobag/edges/delaunay_edges2.hpp>

#include "camera_option.hpp"
#include "catch.hpp"
#include "error_text.hpp"
#include "keyframe_graphs.hpp"
#include "sample.hpp"
#include "scratch.hpp"

using namespace program;

namespace {

const topobag::PinholeCamera<> camera{500.0, 500.0, 319.5, 239.5, 640, 480};

/// Frames at the given times, each of which sees one cup 2 m before it.
NodeTable table_at(const std::vector<double>& stamps) {
  NodeTable table;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    FrameRow frame;
    frame.idx = static_cast<std::int64_t>(i);
    frame.timestamp = stamps[i];
    frame.T_world_camera = Eigen::Isometry3d::Identity();
    frame.detections.push_back({topobag::box_around({320.0, 240.0}, 50, 50), topobag::ClassId{41}});
    frame.detections.back().z = 2.0;
    table.frames.push_back(std::move(frame));
  }
  return table;
}

std::vector<std::int64_t> selected(const std::vector<double>& stamps, double interval) {
  std::vector<std::int64_t> numbers;
  for (const Keyframe& keyframe : keyframe_graphs(table_at(stamps), {camera, interval, 0.0, 0.3})) {
    numbers.push_back(keyframe.idx);
  }
  return numbers;
}

using Numbers = std::vector<std::int64_t>;

}  // namespace

TEST_CASE("a key frame is the first frame at or after its time, once", "[examples]") {
  CHECK(selected({5.0, 5.1, 5.2, 5.3, 5.4, 5.5}, 0.2) == Numbers{0, 2, 4});
  CHECK(selected({5.0, 5.1, 5.3, 5.4, 5.7}, 0.2) == Numbers{0, 2, 3, 4});
  CHECK(selected({5.0, 9.0, 9.1, 9.25}, 0.2) == Numbers{0, 1, 3});  // 9.0 serves k = 1 … 20
  CHECK(selected({5.0, 5.0, 5.1}, 0.0) == Numbers{0, 1, 2});
  CHECK(selected({5.0, 5.0, 5.1}, 0.05) == Numbers{0, 2});
  CHECK(selected({0.0, 0.4, 0.8, 1.2, 1.6, 2.0}, 0.4) == Numbers{0, 1, 2, 3, 4, 5});
  CHECK(selected({1305031102.1, 1305031102.5, 1305031102.9}, 0.4) == Numbers{0, 1, 2});
  CHECK(selected({5.0, 6.0, 1e9}, 1e-12) == Numbers{0, 1, 2});
}

TEST_CASE("a single frame's graph has the paper's edges and one view", "[examples]") {
  const KeyframeOptions options{camera, 0.0, 0.0, 0.3};
  const NodeTable table = read_node_table(sample_map);
  const std::vector<Keyframe> keyframes = keyframe_graphs(table, options);
  REQUIRE(keyframes.size() == table.frames.size());
  for (const Keyframe& keyframe : keyframes) {
    CHECK(keyframe.graph.edges() == topobag::DelaunayEdges2<>{}(keyframe.graph.nodes()));
    REQUIRE(keyframe.graph.views().size() == 1);
    CHECK(keyframe.graph.views()[0].camera.width == 640);
  }
}

TEST_CASE("people and things without a depth occlude, rooms and doubtful boxes do not",
          "[examples]") {
  NodeTable table = table_at({0.0});
  auto& detections = table.frames[0].detections;
  detections.push_back({topobag::box_around({100, 100}, 80, 80), topobag::ClassId{0}, 0.5, 0.0});
  detections.push_back({topobag::box_around({100, 100}, 80, 80), topobag::ClassId{0}, 0.2, 1.0});
  detections.push_back({topobag::box_around({320, 240}, 600, 400), topobag::ClassId{60}, 0.9, 1.0});
  const auto keyframes = keyframe_graphs(table, {camera, 0.0, 0.0, 0.3});
  const auto& occluders = keyframes[0].graph.views()[0].occluders;
  REQUIRE(occluders.size() == 2);
  CHECK(occluders[0].z == 2.0);
  CHECK(occluders[1].z == 0.0);
  CHECK(occluders[1].box.x1 == 60.0);
}

TEST_CASE("a window fuses the key frames of its length, both ends included", "[examples]") {
  const auto keyframes =
      keyframe_graphs(table_at({0.0, 1.0, 2.0, 3.0, 4.0}), {camera, 0, 2.0, 0.3});
  REQUIRE(keyframes.size() == 5);
  CHECK(keyframes[0].graph.views().size() == 1);
  CHECK(keyframes[1].graph.views().size() == 2);
  for (std::size_t i = 2; i < 5; ++i) CHECK(keyframes[i].graph.views().size() == 3);
  CHECK(keyframes[4].graph.size() == 1);
}

TEST_CASE("a graph does not know where in the world it is", "[examples]") {
  NodeTable table = read_node_table(sample_query);
  const KeyframeOptions options{camera, 0.4, 3.0, 0.3};
  const std::vector<Keyframe> before = keyframe_graphs(table, options);
  const Eigen::Isometry3d elsewhere =
      Eigen::Translation3d(30.0, -20.0, 10.0) * Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX());
  for (FrameRow& frame : table.frames) *frame.T_world_camera = elsewhere * *frame.T_world_camera;
  const std::vector<Keyframe> after = keyframe_graphs(table, options);
  REQUIRE(before.size() == after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    REQUIRE(before[i].graph.size() == after[i].graph.size());
    for (std::size_t n = 0; n < before[i].graph.size(); ++n) {
      CHECK(
          before[i].graph.nodes()[n].position->isApprox(*after[i].graph.nodes()[n].position, 1e-9));
    }
  }
}

TEST_CASE("a window without poses is refused, single frames need none", "[examples]") {
  NodeTable table = table_at({0.0, 1.0, 2.0});
  table.frames[1].T_world_camera.reset();
  const ScratchFolder folder;
  CHECK(error_in(folder, [&] {
          keyframe_graphs(table, {camera, 0.0, 2.0, 0.3});
        }) == "frame idx 1 has no pose, which a window needs; give --window 0");
  CHECK(keyframe_graphs(table, {camera, 0.0, 0.0, 0.3}).size() == 3);
}

TEST_CASE("a pose far from the one before is told with its frame and file",
          "[examples][regression]") {
  NodeTable table = table_at({0.0, 1.0, 2.0});
  for (std::size_t i = 1; i < 3; ++i) table.frames[i].T_world_camera->translation().x() = 1e9;
  CHECK(error_text([&] {
          keyframe_graphs(table, {camera, 0.0, 3.0, 0.3});
        }) ==
        "the pose of frame idx 1 is 1e+09 m away from that of the key frame before; check tx, "
        "ty and tz of both");
  CHECK(keyframe_graphs(table, {camera, 0.0, 0.0, 0.3}).size() == 3);
  table.frames[0].T_world_camera->translation().x() = 1e9;  // far from the origin alone
  CHECK(keyframe_graphs(table, {camera, 0.0, 3.0, 0.3}).size() == 3);
}

TEST_CASE("a key frame uses all detections of its table", "[examples]") {
  NodeTable table = table_at({0.0});
  auto& detections = table.frames[0].detections;
  detections.resize(300, detections.front());
  const auto keyframes = keyframe_graphs(table, {camera, 0.0, 0.0, 0.3});
  CHECK(keyframes[0].graph.views()[0].occluders.size() == 300);
}

TEST_CASE("a table of another camera's images is refused", "[examples][regression]") {
  const ScratchFolder folder;
  KeyframeOptions options{camera, 0.0, 0.0, 0.3};
  options.camera.width = 320;
  options.camera.height = 240;
  CHECK(error_text([&] { read_keyframes(sample_map, options); }).find("fr1_xyz.nodes.csv: ") !=
        std::string::npos);
  CHECK(error_text([&] {
          read_keyframes(sample_map, options);
        }).find(" boxes lie outside the camera's image of 320 x 240 px, the first around ") !=
        std::string::npos);
}

TEST_CASE("intrinsics of another image size are refused", "[examples][regression]") {
  const auto complaint = [](double cx, double cy) {
    return error_text([&] { with_size({500, 500, cx, cy}, {640, 480}); });
  };
  CHECK(complaint(700, 240) ==
        "--camera: the principal point 700, 240 lies far from the middle of an image of 640 x 480 "
        "px; give the intrinsics for that size, or the size that they are for");
  CHECK(complaint(159.3, 127.6).find("far from the middle") != std::string::npos);  // half the size
  CHECK(complaint(320, 480).find("far from the middle") != std::string::npos);
  CHECK(complaint(0.5, 0.5).find("far from the middle") != std::string::npos);  // in shares
  CHECK(with_size({500, 500, 290.0, 270.0}, {640, 480}).width == 640);
}

TEST_CASE("boxes in shares of the image are refused", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string set = folder.path("t");
  folder.write("t.frames.csv", "idx,frame,timestamp\n0,a,1\n");
  folder.write("t.nodes.csv", "idx,class,conf,u,v,w,h,z\n0,tv,0.9,0.5,0.5,0.2,0.3,2\n");
  CHECK(error_in(folder,
                 [&] {
                   read_keyframes(set, {camera, 0.0, 0.0, 0.3});
                 }) ==
        "t.nodes.csv: every box lies in [0, 1], as shares of the image do; a table's are in px");
}

TEST_CASE("a table without a usable key frame is refused with what became of it", "[examples]") {
  KeyframeOptions options{camera, 0.0, 3.0, 1.0};
  const std::string why = error_text([&] { read_keyframes(sample_map, options); });
  CHECK(why.find("fr1_xyz.nodes.csv: none of the 67 key frames has three objects with a position; "
                 "of 772 detections in the table 772 are below --min-confidence, 0 move") !=
        std::string::npos);
}

TEST_CASE("either file of a table stands for it", "[examples]") {
  CHECK(set_name("a/b.nodes.csv") == "a/b");
  CHECK(set_name("a/b.frames.csv") == "a/b");
  CHECK(set_name("a/b.csv") == "a/b.csv");
  CHECK(set_name(".nodes.csv") == ".nodes.csv");
  CHECK(read_node_table(sample_map + ".nodes.csv").frames.size() == 67);
}
