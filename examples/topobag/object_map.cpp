// SPDX-License-Identifier: MIT
#include "object_map.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <utility>

#include <topobag/edges/knn_edges.hpp>

#include "csv_reader.hpp"
#include "input_error.hpp"
#include "json_output.hpp"

namespace program {
namespace {

double finite_number_of(const Json& value, const char* what) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!std::isfinite(number)) throw InputError(std::string(what) + " has to be finite numbers");
  return number;
}

Eigen::Vector3d three_numbers(const Json& value, const char* what) {
  if (!value.is_array() || value.size() != 3) {
    throw InputError(std::string(what) + " has to be three numbers");
  }
  Eigen::Vector3d numbers;
  for (std::size_t i = 0; i < 3; ++i) {
    numbers[static_cast<Eigen::Index>(i)] = finite_number_of(value[i], what);
  }
  return numbers;
}

/// The class that the file gives as a number, such as "66.0".
topobag::ClassId label_numbered(const std::string& text, const topobag::ClassCatalog& catalog,
                                int first) {
  const auto number = parse_number(text);
  const double most = 1e6;
  if (number && *number >= 0.0 && *number < most && *number == std::floor(*number)) {
    const topobag::ClassId label{first + static_cast<int>(*number)};
    if (catalog.contains(label)) return label;
  }
  throw InputError("the class " + text + " is the number of none of the " +
                   std::to_string(static_cast<int>(catalog.size()) - first) +
                   "; name the map's own classes by --map-words");
}

MappedObject mapped_object(const Json& node, const topobag::ClassCatalog& catalog, int first) {
  MappedObject object;
  object.position = three_numbers(node.at("translation"), "translation");
  if (node.contains("radii")) {
    object.extent = 2.0 * three_numbers(node.at("radii"), "radii").cwiseAbs();
  }
  const Json& labels = node.at("baseline_label");
  if (!labels.is_object()) throw InputError("baseline_label has to be weights by class");
  for (const auto& [text, given] : labels.items()) {
    const Json& weight = given.is_array() && !given.empty() ? given.front() : given;
    const double share = finite_number_of(weight, "a class's weight");
    if (share < 0.0) throw InputError("a class's weight is negative");
    if (share > 0.0) object.weights[label_numbered(text, catalog, first)] += share;
  }
  if (object.weights.empty()) throw InputError("it has no class");
  return object;
}

/// No camera of one's own was told to have shown an object of the map, which may be of a class that
/// its detector never reports: that it is missing says next to nothing.
constexpr double unknown_existence = 1.0 / 127.0;

topobag::SemanticNode<> node_of(const MappedObject& object, const ObjectMapOptions& options) {
  double all = 0.0;
  for (const auto& [label, weight] : object.weights) all += weight;
  topobag::SemanticNode<> node;
  node.label = object.label();
  node.position = object.position / options.scale;
  node.z = std::max(node.position->z(), 0.0);
  node.covariance = options.deviation * options.deviation * Eigen::Matrix3d::Identity();
  node.confidence = object.weights.at(node.label) / all;
  node.existence = unknown_existence;
  return node;
}

}  // namespace

topobag::ClassId MappedObject::label() const {
  return std::max_element(weights.begin(), weights.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

void tell_of_relation(const ObjectMapOptions& options, const std::string& map) {
  if (options.relation.empty()) return;
  const std::string name = std::filesystem::path(map).filename().string();
  if (options.learnt_of.empty()) {
    std::cerr << "topobag: " << options.relation
              << " does not say of which map it was learnt, and is taken for one of " << map
              << "; `topobag relate` writes one that does\n";
  } else if (options.learnt_of != name) {
    std::cerr << "topobag: " << options.relation << " was learnt of " << options.learnt_of
              << " and is used for " << map << ": scale, deviation and words are those of the "
              << "other\n";
  }
}

std::vector<MappedObject> read_object_map(const std::string& path,
                                          const topobag::ClassCatalog& catalog, int first) {
  const std::string text = read_file(path);
  std::vector<MappedObject> objects;
  std::size_t number = 0;
  try {
    const Json file = parsed_json(text);
    if (!file.contains("nodes") || !file.at("nodes").is_array()) {
      throw InputError("it is no map of objects, which is JSON with a list of 'nodes'");
    }
    for (const Json& node : file.at("nodes")) {
      ++number;
      objects.push_back(mapped_object(node, catalog, first));
    }
    number = 0;
    if (objects.empty()) throw InputError("there is no object in the map");
  } catch (const std::exception& error) {
    throw InputError(path + (number > 0 ? ", node " + std::to_string(number) : "") + ": " +
                     json_complaint(error));
  }
  return objects;
}

Keyframe object_map_place(const std::vector<MappedObject>& objects,
                          const ObjectMapOptions& options) {
  std::vector<topobag::SemanticNode<>> nodes;
  nodes.reserve(objects.size());
  for (const MappedObject& object : objects) nodes.push_back(node_of(object, options));
  return {0,
          0.0,
          Eigen::Isometry3d::Identity(),
          topobag::make_topology_graph(std::move(nodes), topobag::KnnEdges{}),
          {}};
}

}  // namespace program
