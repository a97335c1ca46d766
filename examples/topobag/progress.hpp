// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include <CLI/CLI.hpp>

namespace program {

/// Adds `--progress`: long work tells of itself also where stderr is no terminal.
void add_progress_option(CLI::App& command);

/// While it lives, what `Progress` tells is of this part of the work: "method 3 of 17: …".
class ProgressPart {
 public:
  ProgressPart(const std::string& what, std::size_t number, std::size_t total);
  ProgressPart(const ProgressPart&) = delete;
  ProgressPart& operator=(const ProgressPart&) = delete;
  ~ProgressPart();

 private:
  std::string outer_;
};

/// Tells on stderr how far long work has come: one live line on a terminal, else, where
/// `--progress` was given, a line every five seconds. Nothing of work that is done at once.
class Progress {
 public:
  /// @param total  steps of the whole work
  /// @param unit   what a step is, plural
  Progress(std::size_t total, std::string unit);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// So many steps are done.
  void step(std::size_t steps = 1);

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_;
  std::string unit_;
  bool terminal_;
  std::size_t done_ = 0;
  Clock::time_point said_ = Clock::now();
};

}  // namespace program
