// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>

#include <topobag/version.hpp>

#include "command_line_complaint.hpp"
#include "commands.hpp"
#include "output_files.hpp"

namespace {

/// Says what is wrong in one line on stderr.
int fail(const std::string& message) {
  std::cerr << "topobag: " << message.substr(0, message.find('\n')) << '\n';
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Recognises places by the objects in them.", "topobag");
  app.require_subcommand(1);
  app.set_version_flag("--version", std::to_string(TOPOBAG_VERSION_MAJOR) + '.' +
                                        std::to_string(TOPOBAG_VERSION_MINOR) + '.' +
                                        std::to_string(TOPOBAG_VERSION_PATCH));
  program::add_compare_command(app);
  program::add_evaluate_command(app);
  program::add_fleet_command(app);
  program::add_info_command(app);
  program::add_explain_command(app);
  program::add_localize_command(app);
  program::add_loops_command(app);
  program::add_map_command(app);
  program::add_merge_command(app);
  program::add_nodes_command(app);
  program::add_relate_command(app);
  program::add_similarity_command(app);
  program::add_trajectory_command(app);
  program::add_view_command(app);
  app.parse_complete_callback([&app] {
    program::require_values(app);
    for (const CLI::App* command : app.get_subcommands()) program::require_outputs(*command);
  });
  try {
    const std::string empty = program::empty_option({argv + 1, argv + argc});
    if (!empty.empty()) return fail(empty + " is empty; give it a value, or leave it out");
    app.parse(argc, argv);
    if (!std::cout.flush()) return fail("the output cannot be written");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == EXIT_SUCCESS) return app.exit(error);  // --help
    return fail(program::complaint(app, error) + "; see " + program::help_of(app));
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(error.path1().string() + ": " + error.code().message());
  } catch (const std::exception& error) {
    return fail(error.what());
  }
  return EXIT_SUCCESS;
}
