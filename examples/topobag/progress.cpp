// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <unistd.h>

#include <iostream>
#include <utility>

namespace program {

namespace {

/// Whether a line every five seconds was asked for.
bool& lines_wanted() {
  static bool wanted = false;
  return wanted;
}

/// Of which part of the work is told.
std::string& part_told() {
  static std::string part;
  return part;
}

}  // namespace

ProgressPart::ProgressPart(const std::string& what, std::size_t number, std::size_t total)
    : outer_(part_told()) {
  part_told() += what + ' ' + std::to_string(number) + " of " + std::to_string(total) + ": ";
}

ProgressPart::~ProgressPart() { part_told() = std::move(outer_); }

void add_progress_option(CLI::App& command) {
  command.add_flag("--progress", lines_wanted(),
                   "Say on stderr how far the work has come, also where that is no terminal");
}

Progress::Progress(std::size_t total, std::string unit)
    : total_(total), unit_(std::move(unit)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  const char* const clear_line = "\r\x1B[K";
  if (terminal_) std::cerr << clear_line << std::flush;
}

void Progress::step(std::size_t steps) {
  done_ += steps;
  const auto now = Clock::now();
  if (!terminal_ && !lines_wanted()) return;
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(5000);
  if (now - said_ < pause) return;
  said_ = now;
  std::cerr << (terminal_ ? "\r" : "") << part_told() << done_ << " of " << total_ << ' ' << unit_
            << (terminal_ ? "\x1B[K" : "\n") << std::flush;
}

}  // namespace program
