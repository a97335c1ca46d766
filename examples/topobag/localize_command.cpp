// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <topobag/evaluation/protocol_text.hpp>

#include "calibration_options.hpp"
#include "commands.hpp"
#include "csv_reader.hpp"
#include "look_up.hpp"
#include "match_svg.hpp"
#include "number_check.hpp"
#include "option_use.hpp"
#include "output_files.hpp"
#include "recognition_options.hpp"
#include "report/recognition_page.hpp"

namespace program {
namespace {

struct LocalizeArguments {
  MapAndQuery tables;
  std::string svg;
  std::optional<double> leave_out_radius;  ///< m
  bool unknown_scale = false;              ///< of the queries
  RecognitionArguments recognition;
  RecognitionReportArguments report;
  CalibrationArguments calibration;
};

/// Whether the queries know which way is down and no key frame of the map does.
bool lacks_vertical(const LocalizeArguments& arguments, const RecognitionRun& run) {
  if (!arguments.recognition.keyframes.gravity.world_up) return false;
  return std::none_of(run.map.begin(), run.map.end(), [](const Keyframe& keyframe) {
    return keyframe.graph.gravity().has_value();
  });
}

/// Throws InputError where an option is given that this run has no use for.
void require_uses(const CLI::App& command, const LocalizeArguments& arguments) {
  require_object_options(command, {arguments.tables.map, arguments.tables.query});
  require_stress_and_gravity(command);
  topobag::parse_protocol(arguments.report.protocol);
  require_with(command, "--protocol", {"--report", "--report-data", "--pairs"});
}

void localize(const LocalizeArguments& arguments) {
  const RecognitionArguments& common = arguments.recognition;
  require_order(common.scoring.limits);
  KeyframeOptions keyframes = common.keyframes;
  keyframes.metric = !arguments.unknown_scale;
  RecognitionRun run = read_map_and_query(arguments.tables, keyframes, common.image_size);
  thin_queries(run, common.query_interval);
  if (arguments.unknown_scale) run.scale = topobag::ScaleRange{};
  run.kept = kept_for(arguments.report);
  look_up_in_map(run, calibration_request(arguments.calibration, common, run),
                 arguments.leave_out_radius);
  require_queries(run, arguments.leave_out_radius
                           ? "a key frame farther away than --leave-out-radius"
                           : "a usable key frame of the map");
  run.in_map = count_in_map(run);
  save_calibration(arguments.calibration, run);
  score(run, common.scoring);
  if (!arguments.svg.empty()) write_file(arguments.svg, match_svg(run));
  write_recognition_report(run, common, arguments.report);
  print_report(run, common);
  if (!common.json && lacks_vertical(arguments, run)) {
    std::cout << "  vertical      the map knows of none, so that --world-up changes nothing\n";
  }
}

}  // namespace

void add_localize_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("localize", "Looks the key frames of one node table up in another");
  const auto arguments = std::make_shared<LocalizeArguments>();
  command
      .add_option(
          "--map", arguments->tables.map,
          "Table of the map (MAP.frames.csv, MAP.nodes.csv), what `map` made of one, or another "
          "system's map of objects, JSON")
      ->required();
  command.add_option("--query", arguments->tables.query, "Table of the key frames to look up")
      ->required();
  add_recognition_options(command, arguments->recognition);
  add_map_options(command, arguments->tables);
  command
      .add_option("--leave-out-radius", arguments->leave_out_radius,
                  "Look a key frame up without the map's that are nearer to it, m: its own place "
                  "is then not in the map [none is left out]")
      ->check(number_within(0.0));
  command.add_flag("--unknown-scale", arguments->unknown_scale,
                   "The query's lengths are in an unknown unit, of a quarter to four of the map's "
                   "metres, as of a monocular front end");
  add_output_option(command, "--svg", arguments->svg, "File to draw the best accepted match in");
  add_calibration_options(command, arguments->calibration);
  add_recognition_report_options(command, arguments->report);
  command.callback([arguments, &command] {
    require_uses(command, *arguments);
    localize(*arguments);
  });
}

}  // namespace program
