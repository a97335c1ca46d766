// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <topobag/recognition/loop_detector.hpp>

#include "commands.hpp"
#include "csv_reader.hpp"
#include "input_error.hpp"
#include "keyframe_options.hpp"
#include "look_up.hpp"
#include "number_check.hpp"
#include "option_use.hpp"
#include "output_files.hpp"
#include "path_kind.hpp"
#include "saved_map.hpp"
#include "view/map_view.hpp"
#include "view/view_page.hpp"

namespace program {
namespace {

struct ViewArguments {
  MapAndQuery tables;
  std::string out;
  bool loops = false;
  double min_gap = topobag::LoopOptions{}.min_gap;  ///< s
  KeyframeOptions keyframes;
  ImageSize image_size;
};

/// The camera that was given, with its image's size; without a focal length where none was.
topobag::PinholeCamera<> camera_of(const ViewArguments& arguments) {
  return with_size(arguments.keyframes.camera, arguments.image_size);
}

/// The map, and what was found of the key frames that are to be looked up in it.
RecognitionRun viewed_run(const ViewArguments& arguments) {
  const bool is_table = !is_saved_map(arguments.tables.map);
  if (is_table) require_map(arguments.tables.map);
  const bool sees = !arguments.keyframes.clusters && !is_object_map(arguments.tables.map);
  if (sees && arguments.keyframes.camera.fx <= 0.0 &&
      (is_table || !arguments.tables.query.empty())) {
    throw InputError("--camera", "a table does not tell of its camera; give its intrinsics");
  }
  RecognitionRun run;
  if (!arguments.tables.query.empty()) {
    run = read_map_and_query(arguments.tables, arguments.keyframes, arguments.image_size);
    look_up_in_map(run);
    require_queries(run, "a usable key frame of the map");
  } else {
    KeyframeOptions options = arguments.keyframes;
    options.camera = camera_of(arguments);
    options.classes = classes_of_maps({arguments.tables.map}, options.classes);
    run.classes = options.classes;
    run.map_set = run.query_set = set_name(arguments.tables.map);
    run.map = read_map(arguments.tables.map, options);
    if (arguments.loops) {
      run.queries = run.map;
      look_up_earlier(run, arguments.min_gap);
      require_queries(run);
    }
  }
  score(run, {});
  return run;
}

void view(const ViewArguments& arguments) {
  const RecognitionRun run = viewed_run(arguments);
  const Json shown = map_view(run, camera_of(arguments), arguments.keyframes.gravity.world_up);
  write_file(arguments.out, view_page(shown));
  std::cout << arguments.out << ": " << shown.at("keyframes").at("name").size() << " key frames, "
            << shown.at("objects").at("class").size() << " objects, " << shown.at("matches").size()
            << " matches";
  if (!run.records.empty()) {
    const auto asked = std::count_if(run.records.begin(), run.records.end(),
                                     [](const QueryRecord& record) { return record.is_query(); });
    std::cout << " of " << asked << " key frames that could be looked up";
    const std::size_t own = arguments.tables.query.empty() ? 0 : count_in_map(run);
    if (own > 0) std::cout << "; " << own << " are the map's own, and find themselves";
  }
  std::cout << '\n';
}

}  // namespace

void add_view_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("view", "Writes a page that shows a map in three dimensions");
  const auto arguments = std::make_shared<ViewArguments>();
  command
      .add_option("map", arguments->tables.map,
                  "Table (MAP.frames.csv, MAP.nodes.csv), or what `map` made of one")
      ->required();
  add_output_option(command, "--out", arguments->out, "HTML page to write")->required();
  CLI::Option* query = command.add_option("--query", arguments->tables.query,
                                          "Table whose key frames are looked up in the map");
  command.add_flag("--loops", arguments->loops, "Look for where the map comes back to a place")
      ->excludes(query);
  command
      .add_option("--min-gap", arguments->min_gap,
                  "Age from which a key frame is an earlier visit, s")
      ->check(number_within(0.0))
      ->capture_default_str();
  add_keyframe_options(command, arguments->keyframes, arguments->image_size);
  command.get_option("--camera")->required(false);
  add_map_options(command, arguments->tables);
  command.callback([arguments, &command] {
    const MapAndQuery& tables = arguments->tables;
    if (tables.query.empty()) require_table_options(command, tables.map);
    require_object_options(command, {tables.map, tables.query});
    require_with(command, "--min-gap", {"--loops"});
    for (const char* option : {"--map-camera", "--map-world-up", "--map-trajectory"}) {
      require_with(command, option, {"--query"});
    }
    require_stress_and_gravity(command);
    view(*arguments);
  });
}

}  // namespace program
