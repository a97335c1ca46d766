// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "query_outcome.hpp"
#include "recognition_options.hpp"
#include "recognition_run.hpp"
#include "report_options.hpp"

namespace program {

/// What `localize` and `loops` are asked to report.
struct RecognitionReportArguments {
  ReportFiles files;
  std::string protocol = default_protocol;  ///< text of a PlaceProtocol
  std::string pairs;                        ///< CSV to write: every candidate that was tried
};

/// Adds the options of the report files, `--protocol` and `--pairs`.
void add_recognition_report_options(CLI::App& command, RecognitionReportArguments& arguments);

/// What the queries have to keep for it.
KeptCandidates kept_for(const RecognitionReportArguments& arguments);

/// Writes what was asked for about a scored run.
/// @param loop_gap  s; given, the run looked for loops at least this old within one sequence
void write_recognition_report(const RecognitionRun& run, const RecognitionArguments& recognition,
                              const RecognitionReportArguments& arguments,
                              std::optional<double> loop_gap = std::nullopt);

}  // namespace program
