// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace program {

/// What is wrong with the command line, in the user's words: the misspelt option or command before
/// what is missing without it.
std::string complaint(const CLI::App& app, const CLI::ParseError& error);

/// The option that stands with `=` and no value behind it, as of a variable that is not set; empty
/// where none does. CLI11 would take the next option for its value.
std::string empty_option(const std::vector<std::string>& words);

/// The help that lists the options in question.
std::string help_of(const CLI::App& app);

}  // namespace program
