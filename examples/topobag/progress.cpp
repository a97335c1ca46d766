// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <unistd.h>

#include <iostream>
#include <utility>

namespace program {

Progress::Progress(std::size_t total, std::string unit)
    : total_(total), unit_(std::move(unit)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  const char* const clear_line = "\r\x1B[K";
  if (terminal_) std::cerr << clear_line << std::flush;
}

void Progress::step() {
  ++done_;
  const auto now = Clock::now();
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(5000);
  if (now - said_ < pause) return;
  said_ = now;
  std::cerr << (terminal_ ? "\r" : "") << done_ << " of " << total_ << ' ' << unit_
            << (terminal_ ? "" : "\n") << std::flush;
}

}  // namespace program
