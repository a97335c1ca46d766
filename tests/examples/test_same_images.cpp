// SPDX-License-Identifier: MIT
#include "same_images.hpp"

#include <random>
#include <string>

#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

const std::string desk_camera_only = " --camera 517.3,516.5,318.6,255.3 ";

std::string said_of_itself(const std::string& arguments) {
  const ProgramRun run = run_program(arguments);
  CAPTURE(arguments, run.err);
  REQUIRE(run.exit_code == 0);
  return run.out;
}

bool holds_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("images are the same by the graph, or by where cameras saw them from", "[examples]") {
  std::mt19937 random(5);
  const topobag::TopologyGraph<> blind_a = random_graph(random, 8),
                                 blind_b = random_graph(random, 8);
  const auto seen = [&] {
    return topobag::make_topology_graph(random_nodes(random, 8, 80, false), topobag::KnnEdges{3},
                                        std::vector<topobag::View<>>(1));
  };
  const topobag::TopologyGraph<> a = seen(), b = seen();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Eigen::Vector3d(3.0, -1.0, 0.5);
  Eigen::Isometry3d near = T, beside = T;
  near.translation().x() += 1e-9;
  beside.translation().x() += 0.01;
  using program::are_of_same_images;
  CHECK(are_of_same_images(a, {}, a, {}));
  CHECK(are_of_same_images(blind_a, T, blind_a, beside));
  CHECK(are_of_same_images(a, T, b, near));
  CHECK_FALSE(are_of_same_images(a, T, b, beside));
  CHECK_FALSE(are_of_same_images(a, T, b, {}));
  CHECK_FALSE(are_of_same_images(blind_a, T, blind_b, T));
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  CHECK_FALSE(are_of_same_images(a, origin, b, origin));
}

TEST_CASE("a sequence is not added to its map by other options", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string map = folder.path("m.bag");
  const std::string add = desk_camera_only + "--out " + map + " --nodes ";
  said_of_itself("map" + add + sample_map);
  const std::string before = content_of(map);
  for (const std::string option : {"--keyframe-interval 1", "--window 0"}) {
    CHECK(refusal("map --append " + option + add + sample_map) ==
          map +
              ": the map holds these key frames already, as session 0: mapped twice, a place is "
              "found by itself");
  }
  CHECK((content_of(map) == before));
  CHECK(holds_part(
      said_of_itself("map --append --keyframe-interval 0" + add + sample_map),
      map + ": 62 of 67 key frames are of images that the map held a key frame of: mapped "
            "twice, a place is found by itself\n"));
  CHECK_FALSE(holds_part(said_of_itself("map --append" + add + sample_query), "mapped twice"));
}

TEST_CASE("explain and view tell the map's own key frames", "[examples][regression]") {
  const ScratchFolder folder;
  const std::string explain =
      "explain --frame 30 --map " + sample_map + desk_camera_only + "--query ";
  const std::string own = "frame 30 is one of the map's own, and finds itself\n";
  CHECK(holds_part(said_of_itself(explain + sample_map), own));
  CHECK_FALSE(holds_part(said_of_itself(explain + sample_query), own));
  using nlohmann::json;
  CHECK(json::parse(said_of_itself(explain + sample_map + " --json")).at("in_map") == true);
  CHECK(json::parse(said_of_itself(explain + sample_query + " --json")).at("in_map") == false);
  const std::string view =
      "view " + sample_map + desk_camera_only + "--out " + folder.path("v.html") + " --query ";
  CHECK(holds_part(
      said_of_itself(view + sample_map),
      " matches of 62 key frames that could be looked up; 62 are the map's own, and find "
      "themselves\n"));
  CHECK_FALSE(holds_part(said_of_itself(view + sample_query), "the map's own"));
}
