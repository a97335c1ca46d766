// SPDX-License-Identifier: MIT
#include <string>

#include "catch.hpp"
#include "depth_column.hpp"
#include "keyframe_graphs.hpp"
#include "node_table.hpp"
#include "scratch.hpp"

using namespace program;

namespace {

std::string depth_error(const std::string& depth) {
  const ScratchFolder folder;
  folder.write("s.frames.csv", "idx,frame,timestamp,depth\n0,a.png,1.0," + depth + "\n");
  return error_in(folder, [&] { read_frames(folder.path("s")); });
}

}  // namespace

TEST_CASE("a table keeps how far its frames see, and their graphs know it", "[examples]") {
  const ScratchFolder folder;
  topobag::DepthGrid::Levels levels{};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i] = static_cast<topobag::DepthGrid::Level>(i % 64);
  }
  NodeTable table;
  table.frames.resize(2);
  table.frames[1].timestamp = 1.0;
  table.frames[0].depth = levels;
  table.frames[1].idx = 1;
  write_node_table(folder.path("s"), table);
  NodeTable back = read_node_table(folder.path("s"));
  CHECK(back.frames[0].depth == levels);
  CHECK_FALSE(back.frames[1].depth);

  KeyframeOptions options;
  options.camera = {500.0, 500.0, 320.0, 240.0, 640, 480};
  options.interval = options.window = 0.0;
  const auto keyframes = keyframe_graphs(back, options);
  REQUIRE(keyframes.size() == 2);
  REQUIRE(keyframes[0].graph.views().at(0).depth);
  CHECK(keyframes[0].graph.views()[0].depth->levels() == levels);
  CHECK_FALSE(keyframes[1].graph.views().at(0).depth);

  table.frames[0].depth.reset();
  write_node_table(folder.path("s"), table);
  CHECK(read_file(folder.path("s.frames.csv")).find("depth") == std::string::npos);
}

TEST_CASE("depth that is none is named", "[examples]") {
  CHECK(depth_error(std::string(80, 'A')) == "nothing was thrown");
  CHECK(depth_error("AAA").find("depth has to be 80 characters, not 3") != std::string::npos);
  CHECK(depth_error(std::string(79, 'A') + "?").find("depth holds '?'") != std::string::npos);
}
