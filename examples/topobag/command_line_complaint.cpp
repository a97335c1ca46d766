// SPDX-License-Identifier: MIT
#include "command_line_complaint.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace program {
namespace {

/// The commands that were given, from the outermost on; the program itself is the first.
std::vector<const CLI::App*> given_commands(const CLI::App& app) {
  std::vector<const CLI::App*> commands{&app};
  for (auto next = app.get_subcommands(); !next.empty(); next = next.front()->get_subcommands()) {
    commands.push_back(next.front());
  }
  return commands;
}

/// "fleet push" of the commands behind the program's name.
std::string words_of(const std::vector<const CLI::App*>& commands) {
  std::string words;
  for (std::size_t i = 1; i < commands.size(); ++i) {
    words += (words.empty() ? "" : " ") + commands[i]->get_name();
  }
  return words;
}

/// How many letters have to be put in, taken out or changed.
std::size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> edits(b.size() + 1);  // from the letters of `a` so far
  std::iota(edits.begin(), edits.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(edits[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = edits[j + 1];
      edits[j + 1] = std::min({changed, edits[j] + 1, diagonal + 1});
    }
  }
  return edits.back();
}

/// The command's option that is written nearly so; empty where none is.
std::string nearest_option(const CLI::App& command, const std::string& word) {
  std::string nearest;
  std::size_t fewest = word.size() < 8 ? 2 : 3;  // edits, exclusive: a mistyped letter or two
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      const std::size_t edits = edits_between("--" + name, word);
      if (edits >= fewest) continue;
      fewest = edits;
      nearest = "--" + name;
    }
  }
  return nearest;
}

/// Whether a word of the command line asks for an option; a negative number does not.
bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         std::isdigit(static_cast<unsigned char>(word[1])) == 0;
}

/// The option that was given more often than it may be; empty where none was.
std::string repeated_option(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_expected_max() == 1 && option->count() > 1) return option->get_name();
  }
  return "";
}

/// The option that took another option for its value; empty where none did.
std::string option_without_value(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      const bool taken = value.rfind("--", 0) == 0 && command.get_option_no_throw(value) != nullptr;
      if (taken) return option->get_name();
    }
  }
  return "";
}

/// What is wrong with a word that the command does not know; empty where there is none.
std::string unknown_word(const std::vector<const CLI::App*>& commands) {
  const CLI::App& command = *commands.back();
  const std::vector<std::string> words = command.remaining();
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  if (option != words.end()) {
    const std::string word = option->substr(0, option->find('='));
    const std::string nearest = nearest_option(command, word);
    return "there is no option " + word + (nearest.empty() ? "" : "; there is " + nearest);
  }
  if (words.empty()) return "";
  if (command.get_require_subcommand_min() == 0) {
    return "'" + words.front() + "' is one argument too many";
  }
  return "there is no command '" + words_of(commands) + ' ' + words.front() + "'";
}

}  // namespace

std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  const std::string said = error.what();
  const std::vector<const CLI::App*> commands = given_commands(app);
  const std::string valueless = option_without_value(*commands.back());
  if (!valueless.empty()) return valueless + " has no value; give it one, or leave it out";
  if (commands.size() > 1) {
    const std::string unknown = unknown_word(commands);
    if (!unknown.empty()) return unknown;
  }
  const std::string not_converted = "Could not convert: ";
  if (said.rfind(not_converted, 0) == 0) {
    return said.substr(not_converted.size()) + " is not a number of its kind";
  }
  const CLI::App& command = *commands.back();
  if (commands.size() > 1 && command.get_require_subcommand_min() > 0) {
    std::string parts;
    for (const CLI::App* part : command.get_subcommands({})) {
      parts += (parts.empty() ? "" : ", ") + part->get_name();
    }
    return "'" + words_of(commands) + "' is followed by one of its commands: " + parts;
  }
  const std::string repeated = repeated_option(*commands.back());
  if (error.get_name() == "ArgumentMismatch" && !repeated.empty()) {
    return repeated + " is given twice";
  }
  if (commands.size() > 1) return said;
  const auto words = app.remaining();
  if (words.empty()) return "give a command";
  if (words.front().rfind('-', 0) == 0) {
    return "a command comes first, then its options such as " + words.front();
  }
  return "there is no command '" + words.front() + "'";
}

std::string empty_option(const std::vector<std::string>& words) {
  const auto empty = std::find_if(words.begin(), words.end(), [](const std::string& word) {
    return word.size() > 3 && word.rfind("--", 0) == 0 && word.find('=') == word.size() - 1;
  });
  return empty == words.end() ? "" : empty->substr(0, empty->size() - 1);
}

std::string help_of(const CLI::App& app) {
  const std::string words = words_of(given_commands(app));
  return "topobag " + words + (words.empty() ? "" : " ") + "--help";
}

}  // namespace program
