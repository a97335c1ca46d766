// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>

#include <topobag/version.hpp>

#include "commands.hpp"
#include "output_files.hpp"

namespace {

/// What is wrong with the command line, where CLI11 does not say it in the user's words.
std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  const std::string said = error.what();
  const std::string not_converted = "Could not convert: ";
  if (said.rfind(not_converted, 0) == 0) {
    return said.substr(not_converted.size()) + " is not a number of its kind";
  }
  if (!app.get_subcommands().empty()) return said;
  const auto words = app.remaining();
  if (words.empty()) return "give a command";
  if (words.front().rfind('-', 0) == 0) {
    return "a command comes first, then its options such as " + words.front();
  }
  return "there is no command '" + words.front() + "'";
}

/// The help that lists the options in question.
std::string help_of(const CLI::App& app) {
  std::string words = "topobag ";
  for (auto commands = app.get_subcommands(); !commands.empty();
       commands = commands.front()->get_subcommands()) {
    words += commands.front()->get_name() + ' ';
  }
  return words + "--help";
}

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
    for (const CLI::App* command : app.get_subcommands()) program::require_outputs(*command);
  });
  try {
    app.parse(argc, argv);
    if (!std::cout.flush()) return fail("the output cannot be written");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == EXIT_SUCCESS) return app.exit(error);  // --help
    return fail(complaint(app, error) + "; see " + help_of(app));
  } catch (const std::exception& error) {
    return fail(error.what());
  }
  return EXIT_SUCCESS;
}
