// SPDX-License-Identifier: MIT
#include "plot_axis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "html_text.hpp"

namespace program {
namespace {

/// The least of 1, 2, 5, 10, … that is at least `size`.
double round_step(double size) {
  const double power = std::pow(10.0, std::floor(std::log10(size)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= size * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

int decimals_of(double step) {
  return std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
}

}  // namespace

std::vector<Tick> round_ticks(double low, double high, std::size_t max_count) {
  const double step = round_step((high - low) / static_cast<double>(max_count - 1));
  const double slack = 1e-6 * step;
  std::vector<Tick> ticks;
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k) {
    ticks.push_back({k * step, fixed_text(k == 0.0 ? 0.0 : k * step, decimals_of(step))});
  }
  return ticks;
}

PlotAxis round_axis(std::string label, double low, double high) {
  if (!(high > low)) {
    const double room = std::max(0.5, 0.1 * std::abs(low));
    low -= room;
    high += room;
  }
  return {std::move(label), low, high, round_ticks(low, high)};
}

PlotAxis axis_from_zero(std::string label, double high) {
  if (!(high > 0.0)) high = 1.0;
  const double step = round_step(high / 6.0);
  return round_axis(std::move(label), 0.0, step * std::ceil(high / step * (1.0 - 1e-9)));
}

}  // namespace program
