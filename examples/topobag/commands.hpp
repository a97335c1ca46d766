// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace program {

// One subcommand each: `add_<name>_command`, in <name>_command.cpp. A command throws
// topobag::Error on bad input and prints its result to stdout at the very end, so that a failure
// leaves no half of it there.
void add_compare_command(CLI::App& app);
void add_evaluate_command(CLI::App& app);
void add_fleet_command(CLI::App& app);
void add_info_command(CLI::App& app);
void add_explain_command(CLI::App& app);
void add_localize_command(CLI::App& app);
void add_loops_command(CLI::App& app);
void add_map_command(CLI::App& app);
void add_merge_command(CLI::App& app);
void add_nodes_command(CLI::App& app);
void add_relate_command(CLI::App& app);
void add_similarity_command(CLI::App& app);
void add_trajectory_command(CLI::App& app);
void add_view_command(CLI::App& app);

}  // namespace program
