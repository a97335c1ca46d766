// SPDX-License-Identifier: MIT
#include "map_view.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "input_error.hpp"
#include "likely_up.hpp"
#include "map_objects.hpp"
#include "match_view.hpp"
#include "view_numbers.hpp"

namespace program {
namespace {

/// The corners of what a camera sees, at a distance of 1 m: left, top, right, bottom.
Json image_bounds(const topobag::PinholeCamera<>& camera) {
  return {rounded(-camera.cx / camera.fx), rounded(-camera.cy / camera.fy),
          rounded((camera.width - camera.cx) / camera.fx),
          rounded((camera.height - camera.cy) / camera.fy)};
}

/// The camera that was given, or the one that the map's graphs remember.
topobag::PinholeCamera<> camera_of(const RecognitionRun& run,
                                   const topobag::PinholeCamera<>& given) {
  if (given.fx > 0.0) return given;
  for (const Keyframe& keyframe : run.map) {
    if (!keyframe.graph.views().empty()) return keyframe.graph.views().back().camera;
  }
  throw InputError(run.map_set, "the map does not tell of its camera; give --camera");
}

/// Names of the classes in the order in which they are first asked for.
class ClassNames {
 public:
  explicit ClassNames(const topobag::ClassCatalog& catalog) : catalog_(catalog) {}

  std::size_t number(topobag::ClassId label) {
    const auto [known, is_new] = numbers_.emplace(label, names_.size());
    if (is_new) {
      names_.push_back(catalog_.contains(label) ? catalog_.name(label)
                                                : "class " + std::to_string(topobag::value(label)));
    }
    return known->second;
  }

  const std::vector<std::string>& names() const { return names_; }

 private:
  const topobag::ClassCatalog& catalog_;
  std::map<topobag::ClassId, std::size_t> numbers_;
  std::vector<std::string> names_;
};

Json objects_json(const std::vector<MapObject>& objects, ClassNames& classes) {
  Json json{{"class", Json::array()}, {"position", Json::array()},  {"size", Json::array()},
            {"sight", Json::array()}, {"keyframes", Json::array()}, {"first", Json::array()},
            {"last", Json::array()}};
  for (const MapObject& object : objects) {
    json["class"].push_back(classes.number(object.label));
    append(json["position"], object.position);
    append(json["size"], object.size);
    append(json["sight"], object.sight);
    json["keyframes"].push_back(object.keyframes.size());
    json["first"].push_back(object.keyframes.front());
    json["last"].push_back(object.keyframes.back());
  }
  return json;
}

/// The objects of a graph, each once, and its edges as pairs of them.
void append_graph(Json& json, const topobag::TopologyGraph<>& graph,
                  const std::vector<std::optional<std::size_t>>& object_of) {
  Json objects = Json::array(), edges = Json::array();
  for (const auto& object : object_of) {
    if (object) objects.push_back(*object);
  }
  for (const topobag::Edge& edge : graph.edges()) {
    const auto& a = object_of[topobag::value(edge.a)];
    const auto& b = object_of[topobag::value(edge.b)];
    if (!a || !b) continue;
    edges.push_back(*a);
    edges.push_back(*b);
  }
  json["objects"].push_back(std::move(objects));
  json["edges"].push_back(std::move(edges));
}

Json keyframes_json(const std::vector<Keyframe>& keyframes, const MapObjects& map) {
  Json json{{"name", Json::array()},     {"time", Json::array()},    {"position", Json::array()},
            {"rotation", Json::array()}, {"objects", Json::array()}, {"edges", Json::array()}};
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const Keyframe& keyframe = keyframes[i];
    json["name"].push_back(name_of(keyframe));
    json["time"].push_back(rounded(keyframe.timestamp));
    append(json["position"], keyframe.T_world_camera->translation());
    append(json["rotation"], Eigen::Quaterniond(keyframe.T_world_camera->linear()).coeffs());
    append_graph(json, keyframe.graph, map.of_nodes[i]);
  }
  return json;
}

/// The key frames with a pose, and where they are in the run's map.
struct PlacedKeyframes {
  std::vector<Keyframe> keyframes;
  std::vector<std::optional<std::size_t>> number_of;  ///< parallel to the run's map

  explicit PlacedKeyframes(const RecognitionRun& run) {
    for (const Keyframe& keyframe : run.map) {
      number_of.emplace_back();
      if (!keyframe.T_world_camera) continue;
      number_of.back() = keyframes.size();
      keyframes.push_back(keyframe);
    }
    if (!keyframes.empty()) return;
    throw InputError(run.map_set, "none of the " + std::to_string(run.map.size()) +
                                      " key frames has a pose, so there is no place to draw them "
                                      "at; give --trajectory");
  }
};

}  // namespace

Json map_view(const RecognitionRun& run, const topobag::PinholeCamera<>& camera,
              const std::optional<Eigen::Vector3d>& up) {
  const PlacedKeyframes placed(run);
  std::vector<Eigen::Isometry3d> poses;
  for (const Keyframe& keyframe : placed.keyframes) poses.push_back(*keyframe.T_world_camera);
  const MapObjects map = map_objects(placed.keyframes, run.classes.lookalikes);
  ClassNames classes(run.classes.catalog);
  const auto asked = std::count_if(run.records.begin(), run.records.end(),
                                   [](const QueryRecord& record) { return record.is_query(); });
  Json json{{"title", name_of(run.map_set)},
            {"without_pose", run.map.size() - placed.keyframes.size()},
            {"image", image_bounds(camera_of(run, camera))},
            {"up", Json::array()},
            {"objects", objects_json(map.objects, classes)},
            {"keyframes", keyframes_json(placed.keyframes, map)},
            {"looked_up", asked},
            {"matches", matches_json(run, placed.number_of, map.of_nodes)}};
  append(json["up"], up ? up->normalized() : likely_up(poses));
  json["classes"] = classes.names();
  return json;
}

}  // namespace program
