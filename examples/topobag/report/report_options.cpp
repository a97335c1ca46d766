// SPDX-License-Identifier: MIT
#include "report_options.hpp"

#include "csv_reader.hpp"
#include "output_files.hpp"

namespace program {

void add_report_options(CLI::App& command, ReportFiles& files) {
  add_output_option(command, "--report", files.page, "HTML page to write: figures of the run");
  add_output_option(command, "--report-data", files.data,
                    "JSON to write: the numbers of the figures");
}

void write_report(const Report& report, const ReportFiles& files) {
  if (!files.page.empty()) write_file(files.page, html_page(report));
  if (!files.data.empty()) {
    write_file(files.data, json_text(report_json(report), 1));
  }
}

}  // namespace program
