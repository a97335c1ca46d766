// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace program {

/// A labelled place on an axis.
struct Tick {
  double value = 0.0;
  std::string text{};
};

/// One axis of a plot.
struct PlotAxis {
  std::string label;  ///< with the unit
  double low = 0.0;
  double high = 1.0;
  std::vector<Tick> ticks{};
};

/// Round numbers in [low, high], at most `max_count` (>= 2) of them, 1, 2 or 5 times a power of ten
/// apart, with just the decimals that they need. Precondition: low < high, finite.
std::vector<Tick> round_ticks(double low, double high, std::size_t max_count = 7);

/// An axis with round ticks, its ends as given. Equal ends are moved apart.
PlotAxis round_axis(std::string label, double low, double high);

/// From 0 to the next tick at or above `high`.
PlotAxis axis_from_zero(std::string label, double high);

}  // namespace program
