// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <limits>
#include <memory>
#include <string>

#include "calibration_options.hpp"
#include "calibration_report.hpp"
#include "commands.hpp"
#include "csv_reader.hpp"
#include "explanation_json.hpp"
#include "look_up.hpp"
#include "match_svg.hpp"
#include "node_table.hpp"
#include "number_check.hpp"
#include "object_map.hpp"
#include "option_use.hpp"
#include "output_files.hpp"
#include "path_kind.hpp"
#include "recognition_options.hpp"

namespace program {
namespace {

struct ExplainArguments {
  MapAndQuery tables;
  std::int64_t frame = 0;
  std::size_t candidates = 3;
  std::string svg;
  bool json = false;
  RecognitionArguments recognition;  ///< its key frames' part
  CalibrationArguments calibration;
};

/// Why a frame cannot be explained: no key frame of the query has its idx.
InputError no_key_frame(const std::string& query, std::int64_t frame) {
  const std::string option = "--frame " + std::to_string(frame);
  if (is_object_map(query)) {
    return {option, "no key frame of the query has this idx: a map of objects is frame 0 alone"};
  }
  CsvReader csv(set_name(query) + ".frames.csv");
  const std::size_t column = csv.column("idx");
  std::int64_t first = std::numeric_limits<std::int64_t>::max();
  std::int64_t last = std::numeric_limits<std::int64_t>::min();
  bool there = false;
  while (csv.next()) {
    const std::int64_t idx = csv.integer(column);
    first = std::min(first, idx);
    last = std::max(last, idx);
    there = there || idx == frame;
  }
  if (there) {
    return {option,
            "no key frame of the query has this idx; --keyframe-interval 0 takes all frames"};
  }
  return {option, "the table has no frame of this idx; it has idx " + std::to_string(first) +
                      " to " + std::to_string(last)};
}

/// Leaves the run the query of this frame alone.
void keep_query(RecognitionRun& run, const std::string& query, std::int64_t frame) {
  const auto found = std::find_if(run.queries.begin(), run.queries.end(),
                                  [&](const Keyframe& one) { return one.idx == frame; });
  if (found == run.queries.end()) throw no_key_frame(query, frame);
  run.queries = {*found};
}

/// The candidate that the drawing shows: the accepted one, or the best.
const topobag::CandidateReport& shown_candidate(const topobag::Recognition& recognition,
                                                std::int64_t frame) {
  if (recognition.accepted) return *recognition.accepted;
  if (recognition.candidates.empty()) {
    throw InputError("--frame " + std::to_string(frame), "there is no candidate to draw");
  }
  return recognition.candidates.front();
}

void explain_frame(const ExplainArguments& arguments) {
  RecognitionRun run = read_map_and_query(arguments.tables, arguments.recognition.keyframes,
                                          arguments.recognition.image_size);
  keep_query(run, arguments.tables.query, arguments.frame);
  run.kept = KeptCandidates::reports;
  look_up_in_map(run, calibration_request(arguments.calibration, arguments.recognition, run));
  save_calibration(arguments.calibration, run);
  topobag::Explanation explanation = explain_look_up(run, 0);
  if (!arguments.svg.empty()) {
    const auto& shown = shown_candidate(run.records[0].recognition, arguments.frame);
    write_file(arguments.svg, candidate_svg(run, 0, shown));
  }
  const bool in_map = count_in_map(run) > 0;
  if (arguments.json) {
    Json json = to_json(explanation, run.map);
    json["in_map"] = in_map;
    if (run.calibrated) json["calibration"] = calibration_json(*run.calibrated);
    std::cout << output_text(json, true);
    return;
  }
  const std::size_t all = explanation.candidates.size();
  explanation.candidates.resize(std::min(all, arguments.candidates));
  const auto map_name = [&](topobag::KeyframeId id) {
    return "map " + name_of(run.map[topobag::value(id)]);
  };
  std::cout << "frame " << arguments.frame << ": " << to_string(explanation, map_name);
  if (all > explanation.candidates.size()) {
    std::cout << "and " << all - explanation.candidates.size() << " more candidates\n";
  }
  if (in_map) {
    std::cout << "frame " << arguments.frame << " is one of the map's own, and finds itself\n";
  }
  if (run.calibrated) std::cout << calibration_lines(*run.calibrated);
}

}  // namespace

void add_explain_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("explain", "Tells why a key frame was or was not found in a map");
  const auto arguments = std::make_shared<ExplainArguments>();
  command
      .add_option("--map", arguments->tables.map,
                  "Table of the map (MAP.frames.csv, MAP.nodes.csv), or what `map` made of one")
      ->required();
  command.add_option("--query", arguments->tables.query, "Table of the key frame to explain")
      ->required();
  command.add_option("--frame", arguments->frame, "Its idx in the table")
      ->required()
      ->check(frame_number());
  add_keyframe_options(command, arguments->recognition.keyframes,
                       arguments->recognition.image_size);
  add_map_options(command, arguments->tables);
  add_calibration_options(command, arguments->calibration);
  command.add_option("--candidates", arguments->candidates, "Candidates to print, best first")
      ->check(whole_number_from(1))
      ->capture_default_str();
  add_output_option(command, "--svg", arguments->svg, "File to draw the best candidate in");
  command.add_flag("--json", arguments->json, "All candidates in JSON");
  command.callback([arguments, &command] {
    require_object_options(command, {arguments->tables.map, arguments->tables.query});
    require_stress_and_gravity(command);
    explain_frame(*arguments);
  });
}

}  // namespace program
