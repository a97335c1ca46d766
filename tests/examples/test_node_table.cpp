// SPDX-License-Identifier: MIT
#include <string>

#include <topobag/sensing/lift_detections.hpp>

#include "catch.hpp"
#include "node_table.hpp"
#include "scratch.hpp"

using namespace program;

namespace {

const std::string frames_header = "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw\n";
const std::string one_frame = frames_header + "0,a.png,1.0,0,0,0,0,0,0,1\n";
const std::string nodes_header = "idx,class_id,class,conf,u,v,w,h,z\n";

NodeTable read(const std::string& frames, const std::string& nodes) {
  const ScratchFolder folder;
  folder.write("s.frames.csv", frames);
  folder.write("s.nodes.csv", nodes);
  return read_node_table(folder.path("s"));
}

std::string error_of(const std::string& frames, const std::string& nodes) {
  const ScratchFolder folder;
  folder.write("s.frames.csv", frames);
  folder.write("s.nodes.csv", nodes);
  return error_in(folder, [&] { read_node_table(folder.path("s")); });
}

std::string error_of_node(const std::string& row) {
  return error_of(one_frame, nodes_header + row);
}
std::string error_of_frame(const std::string& row) {
  return error_of(frames_header + row, nodes_header);
}

}  // namespace

TEST_CASE("a node table is read to the letter", "[examples]") {
  const NodeTable table = read(
      "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw,more\n"
      "4,a.png,10.25,1,2,3,0,0,0.6,0.8,?\n"
      "9,b.png,10.5,,,,,,,,?\n",
      "z,h,w,v,u,conf,class,idx\n"
      "0,20,10,50,100,0.5,TVmonitor,9\n"
      "1.5,30,40,60,200,0.25,potted-plant,4\n"
      "2.5,30,40,60,200,1,sofa,4\n");
  REQUIRE(table.frames.size() == 2);
  const FrameRow& a = table.frames[0];
  CHECK(a.idx == 4);
  CHECK(a.name == "a.png");
  CHECK(a.timestamp == 10.25);
  REQUIRE(a.T_world_camera);
  CHECK(a.T_world_camera->translation() == Eigen::Vector3d(1, 2, 3));
  CHECK((a.T_world_camera->linear() * Eigen::Vector3d::UnitX())
            .isApprox(Eigen::Vector3d(0.28, 0.96, 0.0), 1e-12));
  REQUIRE(a.detections.size() == 2);
  CHECK(a.detections[0].label == topobag::ClassId{58});
  CHECK(a.detections[0].confidence == 0.25);
  CHECK(a.detections[0].z == 1.5);
  CHECK(a.detections[0].box.x1 == 180.0);
  CHECK(a.detections[0].box.y1 == 45.0);
  CHECK(a.detections[0].box.x2 == 220.0);
  CHECK(a.detections[0].box.y2 == 75.0);
  CHECK(a.detections[1].label == topobag::ClassId{57});
  CHECK_FALSE(table.frames[1].T_world_camera);
  CHECK(table.frames[1].detections.size() == 1);
}

TEST_CASE("a table's rows lift to nodes as they are", "[examples]") {
  const NodeTable table = read(one_frame, nodes_header +
                                              "0,62,tv,0.9,100,50,20,10,2\n"
                                              "0,62,tv,0.9,200,50,20,10,0\n"
                                              "0,0,person,0.9,300,50,20,10,2\n");
  const auto lifted =
      topobag::lift_detections(table.frames[0].detections, topobag::PinholeCamera<>{500, 500, 0, 0},
                               topobag::ClassCatalog::coco80());
  REQUIRE(lifted.nodes.size() == 1);
  CHECK(lifted.nodes[0].position->isApprox(Eigen::Vector3d(0.4, 0.2, 2.0), 1e-12));
  CHECK(lifted.dropped.no_depth == 1);
  CHECK(lifted.dropped.dynamic == 1);
}

TEST_CASE("a table needs no poses", "[examples]") {
  const NodeTable table = read("idx,frame,timestamp\n0,a,1\n1,b,2\n", "idx,class,conf,u,v,w,h,z\n");
  REQUIRE(table.frames.size() == 2);
  CHECK_FALSE(table.frames[0].T_world_camera);
  CHECK(table.frames[0].detections.empty());
}

TEST_CASE("bad frames are refused with file and line", "[examples]") {
  CHECK(error_of(frames_header, nodes_header) == "s.frames.csv: the table holds no frame");
  CHECK(error_of("idx,frame\n", nodes_header) ==
        "s.frames.csv:1: there is no column 'timestamp'; the header names 'idx' 'frame'");
  CHECK(error_of("idx,frame,timestamp,tx\n", nodes_header).find("there is no column 'ty'") !=
        std::string::npos);
  CHECK(error_of_frame("0,a,nan,0,0,0,0,0,0,1\n") ==
        "s.frames.csv:2: column 'timestamp' holds 'nan', which is not a finite number");
  CHECK(error_of_frame("0,a,1,0,0,,0,0,0,1\n") ==
        "s.frames.csv:2: column 'tz' holds '', which is not a finite number");
  CHECK(error_of_frame("0,a,1,0,0,0,0,0,0,2\n") ==
        "s.frames.csv:2: the quaternion (the last four numbers, qx qy qz qw) does not have unit "
        "length, but 2.000000");
  CHECK(error_of_frame("0,a,1,0,0,0,0,0,0,1\n0,b,2,0,0,0,0,0,0,1\n") ==
        "s.frames.csv:3: idx 0 is there twice");
  CHECK(error_of_frame("0,a,2,0,0,0,0,0,0,1\n1,b,1,0,0,0,0,0,0,1\n") ==
        "s.frames.csv:3: the timestamp is before that of the row above; sort the frames by time");
  CHECK(error_of_frame("0,a,2,0,0,0,0,0,0,1\n1,b,2,0,0,0,0,0,0,1\n") ==
        "s.frames.csv:3: the timestamp is that of the row above; write stamps with their fractions "
        "of a second, and each image once");
}

TEST_CASE("bad nodes are refused with file and line", "[examples]") {
  CHECK(error_of_node("") == "nothing was thrown");
  CHECK(error_of_node("7,62,tv,0.9,1,1,1,1,1\n") ==
        "s.nodes.csv:2: idx 7 is not among the frames, from 0 to 0; are both files of one table?");
  CHECK(error_of_node("0,,tv,0.9,1,1,1,1,1\n0,62,telly,0.9,1,1,1,1,1\n")
            .find("s.nodes.csv:3: unknown class 'telly'; nearest known: ") == 0);
  CHECK(error_of_node("0,63,tv,0.9,1,1,1,1,1\n") ==
        "s.nodes.csv:2: class_id 63 does not go with 'tv', which is number 62");
  CHECK(error_of_node("0,tv,tv,0.9,1,1,1,1,1\n") ==
        "s.nodes.csv:2: column 'class_id' holds 'tv', which is not an integer");
  CHECK(error_of_node("0,62,tv,1.1,1,1,1,1,1\n") ==
        "s.nodes.csv:2: conf has to lie in [0, 1], not 1.1");
  CHECK(error_of_node("0,62,tv,0.9,nan,1,1,1,1\n") ==
        "s.nodes.csv:2: column 'u' holds 'nan', which is not a finite number");
  CHECK(error_of_node("0,62,tv,0.9,1,1,0,1,1\n") ==
        "s.nodes.csv:2: w and h, the size of the box, have to be positive");
  CHECK(error_of_node("0,62,tv,0.9,1,1,1,1,nan\n") ==
        "s.nodes.csv:2: z is nan; it has to be positive, or 0 where it is not known");
  CHECK(error_of_node("0,62,tv,0.9,1,1,1,1,-1\n") ==
        "s.nodes.csv:2: z is -1; it has to be positive, or 0 where it is not known");
}

TEST_CASE("numbers stand for classes where a table has no names", "[examples]") {
  const std::string header = "idx,class_id,conf,u,v,w,h,z\n";
  const NodeTable table = read(one_frame, header + "0,62,0.9,1,1,1,1,1\n");
  CHECK(table.frames.at(0).detections.at(0).label == topobag::ClassId{62});
  for (const std::string number : {"80", "-1", "4294967296"}) {
    CHECK(error_of(one_frame, header + "0," + number + ",0.9,1,1,1,1,1\n") ==
          "s.nodes.csv:2: class_id " + number +
              " is the number of no class; give the table's classes by --classes");
  }
  CHECK(error_of(one_frame, "idx,conf,u,v,w,h,z\n").find("there is no column 'class'") !=
        std::string::npos);
}

TEST_CASE("a missing half of a table is named", "[examples]") {
  const ScratchFolder folder;
  CHECK(error_in(folder, [&] { read_node_table(folder.path("s")); }) ==
        "s.frames.csv: the file cannot be opened; check the path");
  folder.write("s.frames.csv", one_frame);
  CHECK(error_in(folder, [&] { read_node_table(folder.path("s")); }) ==
        "s.nodes.csv: the file cannot be opened; check the path");
}

TEST_CASE("writing what was read gives the same files", "[examples]") {
  const std::string frames = frames_header +
                             "0,a.png,1305031102.175304,1.34064,-0.62662,1.65765,0.60000,0.00000,"
                             "0.00000,0.80000\n3,b.png,1305031102.211214,,,,,,,\n";
  const std::string nodes = nodes_header +
                            "0,66,keyboard,0.849,459.1,404.0,254.0,135.7,1.013\n"
                            "3,58,potted plant,0.100,80.1,79.5,159.6,159.5,0.000\n";
  const NodeTable table = read(frames, nodes);
  const ScratchFolder folder;
  write_node_table(folder.path("out"), table);
  CHECK(read_file(folder.path("out.frames.csv")) == frames);
  CHECK(read_file(folder.path("out.nodes.csv")) == nodes);
}

TEST_CASE("a frame's name that would break the table is refused", "[examples]") {
  const ScratchFolder folder;
  NodeTable table = read(one_frame, nodes_header);
  table.frames[0].name = "a,b.png";
  CHECK(error_in(folder, [&] { write_node_table(folder.path("out"), table); }) ==
        "out.frames.csv: the name of frame 0 holds a comma, a quote or a line break");
}
