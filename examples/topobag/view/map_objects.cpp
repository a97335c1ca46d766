// SPDX-License-Identifier: MIT
#include "map_objects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <topobag/graph/object_track.hpp>
#include <topobag/types/semantic_node.hpp>

namespace program {
namespace {

using Node = topobag::SemanticNode<>;

/// A node with its position and covariance in the world.
Node in_world(Node node, const Eigen::Isometry3d& T_world_camera) {
  node.position = T_world_camera * *node.position;
  node.covariance = T_world_camera.linear() * node.covariance * T_world_camera.linear().transpose();
  return node;
}

/// An object while nodes join it.
struct GrowingObject {
  Node mean;  ///< of its nodes; the covariance is theirs too, as biases do not average out
  Eigen::Vector3d sights = Eigen::Vector3d::Zero();
  std::map<topobag::ClassId, double> votes{};
  std::vector<std::size_t> keyframes{};

  void add(const Node& node, const Eigen::Vector3d& sight, std::size_t keyframe) {
    const double share = 1.0 / static_cast<double>(keyframes.size() + 1);
    *mean.position += share * (*node.position - *mean.position);
    mean.covariance += share * (node.covariance - mean.covariance);
    mean.size += share * (node.size - mean.size);
    sights += sight;
    votes[node.label] += node.confidence;
    mean.label = std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
                   return a.second < b.second;
                 })->first;
    keyframes.push_back(keyframe);
  }
};

class MapObjectsBuilder {
 public:
  MapObjectsBuilder(const topobag::ClassGroups& classes, const MapObjectOptions& options)
      : classes_(classes), options_(options) {}

  /// Joins a key frame's nodes; which objects they are.
  std::vector<std::optional<std::size_t>> add(const Keyframe& keyframe, std::size_t number);

  std::vector<MapObject> objects() const;

 private:
  using Cell = std::array<long, 3>;

  Cell cell_of(const Eigen::Vector3d& position) const {
    const Eigen::Vector3d cell = (position / options_.max_distance).array().floor();
    return {std::lround(cell.x()), std::lround(cell.y()), std::lround(cell.z())};
  }

  /// How far a node is from an object; nothing where it is another one.
  std::optional<double> distance(const Node& node, const GrowingObject& object) const {
    if (!classes_.compatible(node.label, object.mean.label)) return std::nullopt;
    const double apart = (*node.position - *object.mean.position).norm();
    if (apart > options_.max_distance) return std::nullopt;
    const double smaller = std::min(node.size.norm(), object.mean.size.norm());
    const bool same = apart < options_.share * smaller ||
                      topobag::deviations_apart(node, object.mean) < options_.gate;
    return same ? std::make_optional(apart) : std::nullopt;
  }

  template <typename Call>
  void for_each_near(const Eigen::Vector3d& position, const Call& call) const {
    const Cell center = cell_of(position);
    for (long x = -1; x <= 1; ++x) {
      for (long y = -1; y <= 1; ++y) {
        for (long z = -1; z <= 1; ++z) {
          const auto found = cells_.find({center[0] + x, center[1] + y, center[2] + z});
          if (found == cells_.end()) continue;
          for (const std::size_t object : found->second) call(object);
        }
      }
    }
  }

  void add(std::size_t object, const Node& node, const Eigen::Vector3d& sight,
           std::size_t keyframe) {
    const Cell before = cell_of(*objects_[object].mean.position);
    objects_[object].add(node, sight, keyframe);
    const Cell after = cell_of(*objects_[object].mean.position);
    if (before == after) return;
    auto& left = cells_[before];
    left.erase(std::find(left.begin(), left.end(), object));
    cells_[after].push_back(object);
  }

  std::size_t add_object(const Node& node) {
    objects_.push_back({node});
    cells_[cell_of(*node.position)].push_back(objects_.size() - 1);
    return objects_.size() - 1;
  }

  const topobag::ClassGroups& classes_;
  const MapObjectOptions& options_;
  std::vector<GrowingObject> objects_;
  std::map<Cell, std::vector<std::size_t>> cells_;  ///< objects by where they are
};

std::vector<std::optional<std::size_t>> MapObjectsBuilder::add(const Keyframe& keyframe,
                                                               std::size_t number) {
  std::vector<std::optional<std::size_t>> object_of(keyframe.graph.size());
  if (!keyframe.T_world_camera) return object_of;
  std::vector<std::optional<Node>> nodes(keyframe.graph.size());
  std::vector<std::tuple<double, std::size_t, std::size_t>> near;  // distance, node, object
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!keyframe.graph.nodes()[i].position) continue;
    nodes[i] = in_world(keyframe.graph.nodes()[i], *keyframe.T_world_camera);
    for_each_near(*nodes[i]->position, [&](std::size_t object) {
      const auto apart = distance(*nodes[i], objects_[object]);
      if (apart) near.emplace_back(*apart, i, object);
    });
  }
  std::sort(near.begin(), near.end());
  for (const auto& [apart, i, object] : near) {
    const bool taken = std::find(object_of.begin(), object_of.end(), object) != object_of.end();
    if (!object_of[i] && !taken) object_of[i] = object;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i]) continue;
    if (!object_of[i]) object_of[i] = add_object(*nodes[i]);
    const Eigen::Vector3d ray = *nodes[i]->position - keyframe.T_world_camera->translation();
    add(*object_of[i], *nodes[i], ray.normalized(), number);
  }
  return object_of;
}

std::vector<MapObject> MapObjectsBuilder::objects() const {
  std::vector<MapObject> objects;
  for (const GrowingObject& object : objects_) {
    objects.push_back({object.mean.label, *object.mean.position, object.mean.size,
                       object.sights / static_cast<double>(object.keyframes.size()),
                       object.keyframes});
  }
  return objects;
}

}  // namespace

MapObjects map_objects(const std::vector<Keyframe>& keyframes, const topobag::ClassGroups& classes,
                       const MapObjectOptions& options) {
  MapObjectsBuilder builder(classes, options);
  MapObjects map;
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    map.of_nodes.push_back(builder.add(keyframes[i], i));
  }
  map.objects = builder.objects();
  return map;
}

}  // namespace program
