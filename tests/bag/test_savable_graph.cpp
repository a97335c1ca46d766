// SPDX-License-Identifier: MIT
#include <sstream>
#include <vector>

#include <topobag/bag/savable_graph.hpp>
#include <topobag/bag/snapshot.hpp>

#include "bag/careless_bag.hpp"
#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

TEST_CASE("what a map takes can be saved: add and save go by one rule", "[bag]") {
  std::vector<SemanticNode<>> far(3);
  far[1].position = Eigen::Vector3d(0, 0, 1048577.0);
  View<> far_camera;
  far_camera.T_graph_camera.translation().y() = 1048577.0;
  const TopologyGraph<> refused[] = {TopologyGraph<>(std::vector<SemanticNode<>>(4097)),
                                     TopologyGraph<>(far),
                                     TopologyGraph<>({}, {}, {far_camera})};
  for (const TopologyGraph<>& graph : refused) {
    BagOfTopologyGraphs<> bag;
    const std::string why = error_text([&] { bag.add(KeyframeId{5}, graph); });
    CHECK(why == error_text([&] { require_savable(graph); }));
    CHECK(why == error_text([&] { encode(graph); }));
    CHECK(why != "nothing was thrown");
    CHECK(bag.empty());
  }
  CHECK_NOTHROW(require_savable(refused[2], ViewSection::left_out));
}

TEST_CASE("a graph that another bag lets through is named when it cannot be saved", "[bag]") {
  std::ostringstream stream;
  CHECK(error_text([&] { save(CarelessBag{}, stream); }) ==
        "key frame 12: a graph of 5000 nodes; a map keeps up to 4096");
}
