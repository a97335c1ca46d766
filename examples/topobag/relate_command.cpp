// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include <topobag/recognition/decision_options.hpp>

#include "commands.hpp"
#include "input_error.hpp"
#include "keyframe_options.hpp"
#include "map_relation.hpp"
#include "option_use.hpp"
#include "output_files.hpp"
#include "path_kind.hpp"
#include "recognition_run.hpp"

namespace program {
namespace {

struct RelateArguments {
  std::string map;
  std::string query;
  std::string out;
  KeyframeOptions keyframes;
  ImageSize image_size;
};

void relate(const RelateArguments& arguments) {
  require_object_map(arguments.map, "relate");
  if (path_kind(arguments.query) == PathKind::object_map) {
    throw InputError(
        arguments.query,
        "it is a map of objects; --query is the table of a run, to learn what the map's "
        "objects are called there");
  }
  KeyframeOptions options = arguments.keyframes;
  options.camera = with_size(options.camera, arguments.image_size);
  const auto objects = read_object_map(arguments.map, options.classes.catalog,
                                       options.classes.first_word.value_or(0));
  const std::vector<Keyframe> queries = read_keyframes(arguments.query, options);
  const Keyframe& last = queries.back();
  const std::optional<LearntRelation> learnt = learn_relation(objects, last);
  if (!learnt) {
    throw InputError(arguments.map,
                     "no alignment is believed: no four of its objects lie as the query's do");
  }
  std::ostringstream said;
  const topobag::DecisionOptions decision;
  const double asked = decision.threshold(1);
  said << learnt->objects << " of " << objects.size() << " objects coincide with the "
       << last.graph.size() << " of idx " << last.idx << ", whatever their classes: score "
       << learnt->significance << " of " << asked << ", the next best alignment "
       << learnt->next_best << "\nscale " << learnt->relation.scale << ", deviation "
       << learnt->relation.deviation << " m\n";
  for (const SharedObjects& shared : learnt->relation.classes) {
    said << "  " << options.classes.catalog.name(shared.map) << ": " << shared.count << ' '
         << options.classes.catalog.name(shared.query) << '\n';
  }
  const bool believed = learnt->significance >= asked &&
                        learnt->significance - learnt->next_best >= decision.min_lead;
  if (!believed) {
    throw InputError(arguments.map, "no alignment is believed: " + said.str());
  }
  MapRelation relation = learnt->relation;
  relation.map = name_of(arguments.map);
  write_relation(arguments.out, relation, options.classes.catalog);
  std::cout << said.str();
}

}  // namespace

void add_relate_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "relate",
      "Learns by geometry alone how another system's map of objects goes together with one's own "
      "detections: its scale, how exact it is, and what its classes are called");
  const auto arguments = std::make_shared<RelateArguments>();
  command.add_option("--map", arguments->map, "Map of objects, JSON")->required();
  command
      .add_option("--query", arguments->query,
                  "Table of a run; the objects of its last key frame's --window are compared")
      ->required();
  add_output_option(command, "--out", arguments->out, "Relation to write, JSON")->required();
  add_keyframe_options(command, arguments->keyframes, arguments->image_size);
  command.callback([arguments, &command] {
    require_without(command, {"--object-scale", "--object-deviation", "--map-relation"},
                    "it is what relate learns; leave it out");
    require_stress_and_gravity(command);
    relate(*arguments);
  });
}

}  // namespace program
