// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace program {

/// Tells on stderr how far long work has come: one live line on a terminal, else a line every five
/// seconds.
class Progress {
 public:
  /// @param total  steps of the whole work
  /// @param unit   what a step is, plural
  Progress(std::size_t total, std::string unit);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// One step is done.
  void step();

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_;
  std::string unit_;
  bool terminal_;
  std::size_t done_ = 0;
  Clock::time_point said_ = Clock::now();
};

}  // namespace program
