// SPDX-License-Identifier: MIT
#include "map_relation.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iomanip>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include <topobag/matching/judge_pose.hpp>
#include <topobag/matching/learn_confusion.hpp>
#include <topobag/types/catalog_fingerprint.hpp>

#include "csv_reader.hpp"
#include "input_error.hpp"
#include "json_output.hpp"
#include "object_alignment.hpp"

namespace program {
namespace {

/// Of the classes that a relation is learnt by, as its file has it.
std::string fingerprint_text(const topobag::ClassCatalog& catalog) {
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << topobag::fingerprint(catalog);
  return text.str();
}

using ObjectGraph = topobag::TopologyGraph<>;

/// The options under which all objects are of one class, and none need show.
topobag::MatchOptions without_classes(const ObjectGraph& map, const ObjectGraph& query) {
  topobag::MatchOptions options;
  const topobag::ClassId any = query.nodes().front().label;
  for (const ObjectGraph* graph : {&map, &query}) {
    for (const auto& node : graph->nodes()) options.consistency.classes.join(any, node.label);
  }
  options.chance.relabeling = 0.0;
  return options;
}

ObjectGraph scaled_graph(const std::vector<MappedObject>& map, double scale, double deviation) {
  return object_map_place(map, {deviation, scale}).graph;
}

/// An alignment and what the objects say of it.
struct Judged {
  double scale = 1.0;
  ObjectGraph map;
  topobag::RelativePose pose;
};

/// By how much the map's objects of a pose are farther apart than the query's.
double scale_between(const Judged& judged, const ObjectGraph& query) {
  const auto n = static_cast<Eigen::Index>(judged.pose.inliers.size());
  Eigen::Matrix3Xd there(3, n), here(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& pair = judged.pose.inliers[static_cast<std::size_t>(i)];
    there.col(i) = *judged.map.node(pair.candidate).position;
    here.col(i) = *query.node(pair.query).position;
  }
  return Eigen::umeyama(here, there, true).topLeftCorner<3, 3>().col(0).norm();
}

/// An alignment with the scale that its objects say.
std::optional<Judged> judged_alignment(const std::vector<MappedObject>& map,
                                       const ObjectGraph& query, const ScaledMotion& motion,
                                       double deviation) {
  const int rounds = 4;  // the objects rarely change after the second
  std::optional<Judged> found;
  double scale = motion.scale;
  Eigen::Isometry3d T = motion.T_map_query;
  for (int round = 0; round < rounds; ++round) {
    ObjectGraph graph = scaled_graph(map, scale, deviation);
    const auto pose = topobag::judge_pose(graph, query, T, without_classes(graph, query));
    if (!pose) return std::nullopt;
    T = pose->T_candidate_query;
    found = Judged{scale, std::move(graph), *pose};
    scale *= scale_between(*found, query);
  }
  return found;
}

/// What is left of the residuals, along each axis, when the query's own doubt is taken off. A pose
/// and a scale of n objects take up 7 of 3n numbers.
double deviation_left(const Judged& judged, const ObjectGraph& query) {
  double squares = 0.0, own = 0.0;
  for (const topobag::Correspondence& pair : judged.pose.inliers) {
    const auto& node = query.node(pair.query);
    const Eigen::Vector3d at = judged.pose.T_candidate_query * *node.position;
    squares += (*judged.map.node(pair.candidate).position - at).squaredNorm();
    own += node.covariance.trace();
  }
  const double numbers = 3.0 * static_cast<double>(judged.pose.inliers.size());
  const double least = 0.01;  // m
  return std::sqrt(std::max(least * least, squares / (numbers - 7.0) - own / numbers));
}

std::vector<Eigen::Vector3d> positions(const ObjectGraph& graph) {
  std::vector<Eigen::Vector3d> found;
  for (const auto& node : graph.nodes()) found.push_back(*node.position);
  return found;
}

}  // namespace

std::optional<LearntRelation> learn_relation(const std::vector<MappedObject>& map,
                                             const Keyframe& query) {
  const double deviation = MapRelation{}.deviation;
  const ObjectGraph& own = query.graph;
  std::vector<Judged> found;
  for (const ScaledMotion& motion :
       propose_alignments(positions(scaled_graph(map, 1.0, deviation)), positions(own))) {
    if (auto alignment = judged_alignment(map, own, motion, deviation)) {
      found.push_back(std::move(*alignment));
    }
  }
  const auto best = std::max_element(
      found.begin(), found.end(),
      [](const Judged& a, const Judged& b) { return a.pose.significance < b.pose.significance; });
  if (best == found.end() || best->pose.inliers.size() < 4) return std::nullopt;
  LearntRelation learnt;
  learnt.objects = best->pose.inliers.size();
  learnt.significance = best->pose.significance;
  const topobag::MatchOptions limits;
  for (const Judged& other : found) {
    const Eigen::Isometry3d between =
        best->pose.T_candidate_query.inverse() * other.pose.T_candidate_query;
    const bool elsewhere = between.translation().norm() > limits.distinct_translation ||
                           Eigen::AngleAxisd(between.linear()).angle() > limits.distinct_rotation;
    if (elsewhere) learnt.next_best = std::max(learnt.next_best, other.pose.significance);
  }
  learnt.relation.scale = best->scale;
  learnt.relation.deviation = deviation_left(*best, own);
  std::map<std::pair<topobag::ClassId, topobag::ClassId>, double> counts;
  for (const topobag::Correspondence& pair :
       topobag::coincident_objects(best->map, own, best->pose)) {
    counts[{best->map.node(pair.candidate).label, own.node(pair.query).label}] += 1.0;
  }
  for (const auto& [labels, count] : counts) {
    learnt.relation.classes.push_back({labels.first, labels.second, count});
  }
  return learnt;
}

topobag::ClassConfusion confusion_of(const MapRelation& relation, const ObjectClasses& classes) {
  topobag::ConfusionPrior prior;
  prior.classes = classes.catalog.size();
  if (classes.first_word) {
    prior.same = 1e-9;  // no query has it
    prior.classes = static_cast<std::size_t>(*classes.first_word) + 1;
  }
  topobag::ClassConfusion confusion(prior);
  for (const SharedObjects& shared : relation.classes) {
    confusion.add(shared.map, shared.query, shared.count);
  }
  return confusion;
}

void write_relation(const std::string& path, const MapRelation& relation,
                    const topobag::ClassCatalog& catalog) {
  Json classes = Json::array();
  for (const SharedObjects& shared : relation.classes) {
    classes.push_back({{"map", catalog.name(shared.map)},
                       {"query", catalog.name(shared.query)},
                       {"objects", shared.count}});
  }
  write_file(path, output_text({{"map", relation.map},
                                {"catalog", fingerprint_text(catalog)},
                                {"scale", relation.scale},
                                {"deviation", relation.deviation},
                                {"classes", classes}},
                               true));
}

MapRelation read_relation(const std::string& path, const topobag::ClassCatalog& catalog) {
  const std::string text = read_file(path);
  MapRelation relation;
  try {
    const Json file = Json::parse(text, nullptr, false);
    const bool whole = file.is_object() && file.contains("scale") && file.contains("deviation") &&
                       file.contains("classes");
    if (!whole) throw InputError("it is no relation, as `topobag relate` writes one");
    if (file.contains("map")) relation.map = file.at("map").get<std::string>();
    if (file.contains("catalog") &&
        file.at("catalog").get<std::string>() != fingerprint_text(catalog)) {
      throw InputError("it was learnt of " + (relation.map.empty() ? "a map" : relation.map) +
                       " by other classes than these; give --map-words and --classes as `topobag "
                       "relate` had them, or learn it anew");
    }
    relation.scale = file.at("scale").get<double>();
    relation.deviation = file.at("deviation").get<double>();
    if (!(relation.scale > 0.0 && relation.deviation > 0.0)) {
      throw InputError("scale and deviation have to be positive");
    }
    for (const Json& shared : file.at("classes")) {
      relation.classes.push_back({catalog.at(shared.at("map").get<std::string>()),
                                  catalog.at(shared.at("query").get<std::string>()),
                                  shared.at("objects").get<double>()});
      if (!(relation.classes.back().count > 0.0)) throw InputError("objects have to be counted");
    }
  } catch (const std::exception& error) {
    throw InputError(path, json_complaint(error));
  }
  return relation;
}

}  // namespace program
