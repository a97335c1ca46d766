// SPDX-License-Identifier: MIT
#include <memory>
#include <string>

#include <topobag/evaluation/protocol_text.hpp>
#include <topobag/recognition/loop_detector.hpp>

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

struct LoopsArguments {
  std::string nodes;
  double min_gap = topobag::LoopOptions{}.min_gap;  ///< s
  std::string svg;
  RecognitionArguments recognition;
  RecognitionReportArguments report;
  CalibrationArguments calibration;
};

void find_loops(const CLI::App& command, const LoopsArguments& arguments) {
  const RecognitionArguments& common = arguments.recognition;
  require_order(common.scoring.limits);
  RecognitionRun run = read_sequence(arguments.nodes, common.keyframes, common.image_size);
  require_vertical(command, arguments.nodes, run.map);
  thin_queries(run, common.query_interval);
  run.kept = kept_for(arguments.report);
  look_up_earlier(run, arguments.min_gap, calibration_request(arguments.calibration, common, run));
  require_queries(run);
  save_calibration(arguments.calibration, run);
  score(run, common.scoring);
  if (!arguments.svg.empty()) write_file(arguments.svg, match_svg(run));
  write_recognition_report(run, common, arguments.report, arguments.min_gap);
  print_report(run, common);
}

}  // namespace

void add_loops_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("loops", "Finds where a sequence comes back to an earlier place");
  const auto arguments = std::make_shared<LoopsArguments>();
  command.add_option("--nodes", arguments->nodes, "Table: NODES.frames.csv, NODES.nodes.csv")
      ->required();
  command
      .add_option("--min-gap", arguments->min_gap,
                  "Age from which a key frame is an earlier visit, s")
      ->check(number_within(0.0))
      ->capture_default_str();
  add_recognition_options(command, arguments->recognition);
  add_output_option(command, "--svg", arguments->svg, "File to draw the best loop in");
  add_calibration_options(command, arguments->calibration);
  add_recognition_report_options(command, arguments->report);
  command.callback([arguments, &command] {
    require_object_options(command, {arguments->nodes});
    require_stress_and_gravity(command);
    topobag::parse_protocol(arguments->report.protocol);
    require_with(command, "--protocol", {"--report", "--report-data", "--pairs"});
    find_loops(command, *arguments);
  });
}

}  // namespace program
