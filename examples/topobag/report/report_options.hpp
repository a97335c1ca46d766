// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "html_page.hpp"

namespace program {

/// What a command is asked to write beside its output.
struct ReportFiles {
  std::string page;  ///< HTML
  std::string data;  ///< JSON: the numbers of all figures
};

/// Adds `--report` and `--report-data`.
void add_report_options(CLI::App& command, ReportFiles& files);

/// Whether there is a report to make.
inline bool wanted(const ReportFiles& files) { return !files.page.empty() || !files.data.empty(); }

/// Writes what was asked for. Throws InputError.
void write_report(const Report& report, const ReportFiles& files);

}  // namespace program
