// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <utility>

#include <topobag/recognition/loop_detector.hpp>

#include "commands.hpp"
#include "number_check.hpp"
#include "recognition_options.hpp"
#include "report/recognition_page.hpp"
#include "stopwatch.hpp"

namespace program {
namespace {

struct LoopsArguments {
  std::string nodes;
  topobag::LoopOptions options;
  RecognitionArguments recognition;
  RecognitionReportArguments report;
};

void find_loops(const LoopsArguments& arguments) {
  const RecognitionArguments& common = arguments.recognition;
  require_order(common.scoring.limits);
  KeyframeOptions keyframe_options = common.keyframes;
  keyframe_options.camera = with_size(keyframe_options.camera, common.image_size);

  RecognitionRun run;
  run.map_set = run.query_set = arguments.nodes;
  run.map = run.queries = read_keyframes(arguments.nodes, keyframe_options);
  topobag::LoopOptions options = arguments.options;
  options.recognition = table_recognition_options();
  topobag::LoopDetector<> loops(options);
  for (std::size_t i = 0; i < run.queries.size(); ++i) {
    const Keyframe& query = run.queries[i];
    const Stopwatch watch;
    topobag::Recognition recognition = loops.detect(query.timestamp, query.graph);
    run.look_ups.push_back({std::move(recognition), watch.milliseconds(), {}, {}});
    if (!query.graph.is_matchable()) continue;
    topobag::EntryInfo info;
    info.stamp = query.timestamp;
    loops.bag().add(topobag::KeyframeId{i}, query.graph, std::move(info));
  }
  score(run, common.scoring);
  write_recognition_report(run, common, arguments.report, arguments.options.min_gap);
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
      .add_option("--min-gap", arguments->options.min_gap,
                  "Age from which a key frame is an earlier visit, s")
      ->check(number_within(0.0))
      ->capture_default_str();
  add_recognition_options(command, arguments->recognition);
  add_recognition_report_options(command, arguments->report);
  command.callback([arguments] { find_loops(*arguments); });
}

}  // namespace program
