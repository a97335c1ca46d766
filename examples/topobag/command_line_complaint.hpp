// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace program {

/// What is wrong with the command line, in the user's words: the misspelt option or command before
/// what is missing without it.
std::string complaint(const CLI::App& app, const CLI::ParseError& error);

/// The help that lists the options in question.
std::string help_of(const CLI::App& app);

}  // namespace program
