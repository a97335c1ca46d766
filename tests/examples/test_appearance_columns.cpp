// SPDX-License-Identifier: MIT
#include <random>
#include <string>

#include "appearance_columns.hpp"
#include "catch.hpp"
#include "node_table.hpp"
#include "random_appearance.hpp"
#include "scratch.hpp"

using namespace program;

namespace {

const std::string a_frame = "idx,frame,timestamp\n0,a.png,1.0\n";
const std::string a_header = "idx,class,conf,u,v,w,h,z";
const std::string a_node = "0,cup,0.5,10,10,4,4,1";

NodeTable read_described(const std::string& columns, const std::string& fields) {
  const ScratchFolder folder;
  folder.write("s.frames.csv", a_frame);
  folder.write("s.nodes.csv", a_header + columns + "\n" + fields);
  return read_node_table(folder.path("s"));
}

std::string error_of_described(const std::string& columns, const std::string& fields) {
  const ScratchFolder folder;
  folder.write("s.frames.csv", a_frame);
  folder.write("s.nodes.csv", a_header + columns + "\n" + fields);
  return error_in(folder, [&] { read_node_table(folder.path("s")); });
}

}  // namespace

TEST_CASE("a table may say what its objects look like", "[examples][appearance]") {
  const NodeTable table =
      read_described(",a1,appearance,a0", a_node + ",-128,mine,127\n" + a_node + ",,,\n");
  CHECK(table.appearance == "mine");
  const auto& detections = table.frames.at(0).detections;
  REQUIRE(detections.size() == 2);
  CHECK(detections[0].appearance == topobag::Appearance(topobag::AppearanceKind("mine", 2),
                                                        topobag::Appearance::Bytes{127, -128}));
  CHECK_FALSE(detections[1].appearance.known());
  CHECK(read_described("", a_node + "\n").appearance.empty());
}

TEST_CASE("what a table says of looks comes back as it was written", "[examples][appearance]") {
  std::mt19937 random(1);
  const ScratchFolder folder;
  NodeTable table = read_described("", a_node + "\n" + a_node + "\n" + a_node + "\n");
  const std::string plain = [&] {
    write_node_table(folder.path("plain"), table);
    return read_file(folder.path("plain.nodes.csv"));
  }();
  CHECK(plain.find("idx,class_id,class,conf,u,v,w,h,z\n") == 0);
  table.appearance = "mine";
  const topobag::AppearanceKind kind("mine", topobag::AppearanceKind::max_length);
  for (const std::size_t i : {0U, 2U}) {
    table.frames[0].detections[i].appearance = random_appearance(random, kind);
  }
  write_node_table(folder.path("t"), table);
  const NodeTable back = read_node_table(folder.path("t"));
  CHECK(back.appearance == "mine");
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(back.frames[0].detections[i].appearance == table.frames[0].detections[i].appearance);
  }
}

TEST_CASE("columns of looks that say nothing clear are refused", "[examples][appearance]") {
  const std::string both =
      "columns a0, a1, … say what an object looks like, and column appearance which method gave "
      "them: both are needed, or neither";
  CHECK(error_of_described(",a0", "") == "s.nodes.csv:1: " + both);
  CHECK(error_of_described(",appearance", "") == "s.nodes.csv:1: " + both);
  CHECK(error_of_described(",appearance,a1", "") == "s.nodes.csv:1: " + both);
  CHECK(error_of_described(",appearance,a0", a_node + ",mine,128\n") ==
        "s.nodes.csv:2: a0 has to lie in [-128, 127]");
  CHECK(error_of_described(",appearance,a0", a_node + ",mine,0\n") ==
        "s.nodes.csv:2: a descriptor of zeros has no direction");
  CHECK(error_of_described(",appearance,a0", a_node + ",mine,1\n" + a_node + ",yours,1\n") ==
        "s.nodes.csv:3: appearance 'yours' is another one than 'mine' above: describe all "
        "objects by one method");
  std::string many = ",appearance";
  for (int i = 0; i < 65; ++i) many += ",a" + std::to_string(i);
  CHECK(error_of_described(many, "") ==
        "s.nodes.csv:1: an appearance holds up to 64 numbers, a0 to a63");
}
