// SPDX-License-Identifier: MIT
#include <string>

#include <topobag/types/class_catalog.hpp>

#include "catch.hpp"
#include "object_map.hpp"
#include "scratch.hpp"

using namespace program;

namespace {

const std::string two_objects = R"( {"nodes": [
  {"id": 1, "translation": [1, 2, 3], "radii": [0.1, -0.2, 0.3],
   "baseline_label": {"41.0": [0.7, [255, 0, 0]], "62.0": [0.25], "66": 0.05}},
  {"id": 2, "translation": [4, 5, 6], "baseline_label": {"62": [1.0]}}], "edges": []})";

/// What is said of a map with one node.
std::string object_map_error(const std::string& node) {
  const ScratchFolder folder;
  const std::string path = folder.write("map.json", "{\"nodes\": [" + node + "]}");
  return error_in(folder, [&] { read_object_map(path, topobag::ClassCatalog::coco80()); });
}

}  // namespace

TEST_CASE("a map of objects is read to the letter", "[examples]") {
  const ScratchFolder folder;
  const auto coco = topobag::ClassCatalog::coco80();
  const auto objects = read_object_map(folder.write("map.json", two_objects), coco);
  REQUIRE(objects.size() == 2);
  CHECK(objects[0].position == Eigen::Vector3d(1, 2, 3));
  CHECK(objects[0].extent.isApprox(Eigen::Vector3d(0.2, 0.4, 0.6)));
  CHECK(objects[0].weights == std::map<topobag::ClassId, double>{{coco.at("cup"), 0.7},
                                                                 {coco.at("tv"), 0.25},
                                                                 {coco.at("keyboard"), 0.05}});
  CHECK(objects[0].label() == coco.at("cup"));
  CHECK(objects[1].extent == Eigen::Vector3d::Zero());
}

TEST_CASE("numbers of a map's own words go after the catalog's", "[examples]") {
  const ScratchFolder folder;
  topobag::ClassCatalog catalog = topobag::ClassCatalog::coco80();
  for (int i = 0; i < 70; ++i) {
    catalog.add(topobag::ClassId{80 + i}, "word " + std::to_string(i), topobag::Dynamics::low);
  }
  const auto objects = read_object_map(folder.write("map.json", two_objects), catalog, 80);
  CHECK(catalog.name(objects[0].label()) == "word 41");
}

TEST_CASE("what is wrong with a map of objects is told with its node", "[examples]") {
  const std::string good = R"({"translation": [1, 2, 3], "baseline_label": {"41": [1]}})";
  CHECK(object_map_error(good) == "nothing was thrown");
  CHECK(object_map_error(R"({"translation": [1, 2], "baseline_label": {"41": [1]}})") ==
        "map.json, node 1: translation has to be three numbers");
  CHECK(object_map_error(good + R"(, {"translation": [1, 2, "x"], "baseline_label": {}})") ==
        "map.json, node 2: translation has to be finite numbers");
  CHECK(object_map_error(R"({"translation": [1, 2, 3], "baseline_label": {"80.0": [1]}})") ==
        "map.json, node 1: the class 80.0 is the number of none of the 80; name the map's own "
        "classes by --map-words");
  CHECK(object_map_error(R"({"translation": [1, 2, 3], "baseline_label": {"1.5": [1]}})") ==
        "map.json, node 1: the class 1.5 is the number of none of the 80; name the map's own "
        "classes by --map-words");
  CHECK(object_map_error(R"({"translation": [1, 2, 3], "baseline_label": {"41": [-1]}})") ==
        "map.json, node 1: a class's weight is negative");
  CHECK(object_map_error(R"({"translation": [1, 2, 3], "baseline_label": {"41": [0]}})") ==
        "map.json, node 1: it has no class");
  CHECK(object_map_error("") == "map.json: there is no object in the map");
  const ScratchFolder folder;
  const std::string other = folder.write("other.json", "{\"frames\": []}");
  CHECK(error_in(folder, [&] { read_object_map(other, topobag::ClassCatalog::coco80()); }) ==
        "other.json: it is no map of objects, which is JSON with a list of 'nodes'");
}

TEST_CASE("a map of objects is one place, scaled, with doubt and without views", "[examples]") {
  const ScratchFolder folder;
  const auto objects =
      read_object_map(folder.write("map.json", two_objects), topobag::ClassCatalog::coco80());
  const Keyframe place = object_map_place(objects, {0.1, 2.0});
  REQUIRE(place.graph.size() == 2);
  const auto& cup = place.graph.nodes()[0];
  CHECK(cup.label == objects[0].label());
  CHECK(cup.position->isApprox(Eigen::Vector3d(0.5, 1.0, 1.5)));
  CHECK(cup.covariance.isApprox(0.01 * Eigen::Matrix3d::Identity()));
  CHECK(cup.confidence == Approx(0.7));
  CHECK(cup.existence < 0.01);
  CHECK(cup.size == Eigen::Vector2d::Zero());
  CHECK(place.graph.views().empty());
  CHECK(place.T_world_camera->isApprox(Eigen::Isometry3d::Identity()));
}
