// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <topobag/bag/graph_codec.hpp>
#include <topobag/types/class_catalog.hpp>

#include "commands.hpp"
#include "fleet_address.hpp"
#include "json_output.hpp"
#include "saved_map.hpp"

namespace program {
namespace {

struct InfoArguments {
  std::string map;
  bool json = false;
  ObjectClasses classes;
};

/// What is counted of a session.
struct SessionFigures {
  std::size_t keyframes = 0;
  std::size_t with_pose = 0;
  double first_stamp = std::numeric_limits<double>::infinity();
  double last_stamp = -std::numeric_limits<double>::infinity();
};

/// What is counted of a map.
struct MapFigures {
  std::size_t keyframes = 0, usable = 0, objects = 0, edges = 0, views = 0;
  std::size_t graph_bytes = 0, view_bytes = 0;
  std::map<std::uint32_t, SessionFigures> sessions;
  std::map<topobag::ClassId, std::size_t> classes;

  void add(const topobag::EntryInfo& info, const topobag::TopologyGraph<>& graph) {
    ++keyframes;
    if (graph.is_matchable()) ++usable;
    objects += graph.size();
    edges += graph.edges().size();
    views += graph.views().size();
    const std::size_t without = topobag::encode(graph, topobag::ViewSection::left_out).size();
    graph_bytes += without;
    view_bytes += topobag::encode(graph).size() - without;
    SessionFigures& session = sessions[info.session];
    ++session.keyframes;
    if (info.T_world_camera) ++session.with_pose;
    if (info.stamp) {
      session.first_stamp = std::min(session.first_stamp, *info.stamp);
      session.last_stamp = std::max(session.last_stamp, *info.stamp);
    }
    for (const auto& node : graph.nodes()) ++classes[node.label];
  }
};

/// Classes and how often each stands in a graph, the most frequent first.
Json class_counts(const MapFigures& figures, const topobag::ClassCatalog& catalog) {
  std::vector<std::pair<topobag::ClassId, std::size_t>> ranked(figures.classes.begin(),
                                                               figures.classes.end());
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  Json counts = Json::object();
  for (const auto& [id, count] : ranked) {
    counts[catalog.contains(id) ? catalog.name(id)
                                : "class " + std::to_string(topobag::value(id))] = count;
  }
  return counts;
}

Json session_json(const SavedSession& session, const MapFigures& figures) {
  const auto found = figures.sessions.find(session.id);
  const SessionFigures empty;
  const SessionFigures& counted = found == figures.sessions.end() ? empty : found->second;
  Json json = Json::object();
  if (!session.name.empty()) json["name"] = session.name;
  json["keyframes"] = counted.keyframes;
  json["with_pose"] = counted.with_pose;
  const bool stamped = counted.first_stamp <= counted.last_stamp;
  json["seconds"] = stamped ? Json(counted.last_stamp - counted.first_stamp) : Json();
  return json;
}

void inform(const InfoArguments& arguments) {
  const ObjectClasses classes = classes_of_maps({arguments.map}, arguments.classes);
  const SavedMap map = read_saved_map(arguments.map, classes);
  MapFigures figures;
  map.bag.for_each([&](topobag::KeyframeId, const topobag::EntryInfo& info,
                       const topobag::TopologyGraph<>& graph) { figures.add(info, graph); });
  const auto mean_of = [&](std::size_t sum) {
    if (figures.keyframes == 0) return std::optional<double>();
    const double mean = static_cast<double>(sum) / static_cast<double>(figures.keyframes);
    return std::optional<double>(std::round(mean * 100.0) / 100.0);
  };
  Json sessions = Json::object();
  for (const SavedSession& session : map.sessions) {
    sessions[std::to_string(session.id)] = session_json(session, figures);
  }
  const Json result{{"map", arguments.map},
                    {"format", map.format},
                    {"file_bytes", is_fleet_address(arguments.map)
                                       ? Json()
                                       : Json(std::filesystem::file_size(arguments.map))},
                    {"keyframes", figures.keyframes},
                    {"usable", figures.usable},
                    {"objects_per_keyframe", or_null(mean_of(figures.objects))},
                    {"edges_per_keyframe", or_null(mean_of(figures.edges))},
                    {"views_per_keyframe", or_null(mean_of(figures.views))},
                    {"graph_bytes_per_keyframe", or_null(mean_of(figures.graph_bytes))},
                    {"view_bytes_per_keyframe", or_null(mean_of(figures.view_bytes))},
                    {"sessions", sessions},
                    {"objects", class_counts(figures, classes.catalog)}};
  std::cout << output_text(result, arguments.json);
}

}  // namespace

void add_info_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("info", "Says what a map holds");
  const auto arguments = std::make_shared<InfoArguments>();
  command.add_option("map", arguments->map, "SQLite map, snapshot, or a fleet's: postgresql://…?site=NAME")->required();
  add_classes_option(command, arguments->classes);
  command.add_flag("--json", arguments->json, "In JSON");
  command.callback([arguments] { inform(*arguments); });
}

}  // namespace program
