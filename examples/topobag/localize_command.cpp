// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <utility>

#include <topobag/recognition/relocalizer.hpp>

#include "commands.hpp"
#include "csv_reader.hpp"
#include "match_svg.hpp"
#include "recognition_options.hpp"
#include "report/recognition_page.hpp"
#include "saved_map.hpp"
#include "stopwatch.hpp"

namespace program {
namespace {

struct LocalizeArguments {
  std::string map;
  std::string query;
  topobag::PinholeCamera<> map_camera;
  std::string svg;
  RecognitionArguments recognition;
  RecognitionReportArguments report;
};

void localize(const LocalizeArguments& arguments) {
  const RecognitionArguments& common = arguments.recognition;
  require_order(common.scoring.limits);
  KeyframeOptions query_options = common.keyframes;
  query_options.camera = with_size(query_options.camera, common.image_size);
  KeyframeOptions map_options = query_options;
  if (arguments.map_camera.fx > 0.0) {
    map_options.camera = with_size(arguments.map_camera, common.image_size);
  }

  RecognitionRun run{arguments.map,
                     arguments.query,
                     read_map(arguments.map, map_options),
                     read_keyframes(arguments.query, query_options),
                     {}};
  topobag::Relocalizer<> relocalizer(table_recognition_options());
  for (std::size_t i = 0; i < run.map.size(); ++i) {
    if (!run.map[i].graph.is_matchable()) continue;
    relocalizer.map().add(topobag::KeyframeId{i}, run.map[i].graph);
  }
  for (const Keyframe& query : run.queries) {
    const Stopwatch watch;
    topobag::Recognition recognition = relocalizer.localize(query.graph);
    run.look_ups.push_back({std::move(recognition), watch.milliseconds(), {}, {}});
  }
  score(run, common.scoring);
  if (!arguments.svg.empty()) write_file(arguments.svg, match_svg(run));
  write_recognition_report(run, common, arguments.report);
  print_report(run, common);
}

}  // namespace

void add_localize_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("localize", "Looks the key frames of one node table up in another");
  const auto arguments = std::make_shared<LocalizeArguments>();
  command
      .add_option("--map", arguments->map,
                  "Table of the map (MAP.frames.csv, MAP.nodes.csv), or what `map` made of one")
      ->required();
  command.add_option("--query", arguments->query, "Table of the key frames to look up")->required();
  add_recognition_options(command, arguments->recognition);
  add_camera_option(command, "--map-camera", arguments->map_camera,
                    "The map's camera, where it is another one");
  command.add_option("--svg", arguments->svg, "File to draw the best accepted match in");
  add_recognition_report_options(command, arguments->report);
  command.callback([arguments] { localize(*arguments); });
}

}  // namespace program
