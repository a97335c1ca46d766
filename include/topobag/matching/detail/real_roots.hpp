// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A polynomial of at most the fourth degree, lowest power first.
using Quartic = std::array<double, 5>;

/// p(x), by Horner's rule.
inline double value_of(const Quartic& p, double x) {
  double sum = 0.0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
  return sum;
}

/// p'.
inline Quartic derivative_of(const Quartic& p) {
  Quartic d{};
  for (std::size_t i = 1; i < p.size(); ++i) d[i - 1] = static_cast<double>(i) * p[i];
  return d;
}

/// At most four roots, ascending.
struct Roots {
  std::array<double, 4> x{};
  std::size_t size = 0;

  const double* begin() const noexcept { return x.data(); }
  const double* end() const noexcept { return x.data() + size; }
  void add(double root) {
    if (size < x.size()) x[size++] = root;
  }
};

/// The root of p in [low, high], at whose ends its signs differ and between which p is monotone:
/// Newton's steps, halving where one would leave the interval. To twelve digits.
inline double root_between(const Quartic& p, const Quartic& slope, double low, double high) {
  const bool rising = value_of(p, low) < 0.0;
  double x = 0.5 * (low + high);
  for (int i = 0; i < 100; ++i) {
    const double y = value_of(p, x);
    if (y == 0.0) return x;
    ((y < 0.0) == rising ? low : high) = x;
    double next = x - y / value_of(slope, x);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - x) <= 1e-12 * std::abs(x)) return next;
    x = next;
  }
  return x;
}

/// The real roots of p in [low, high], 0 < low < high, and where it nearly touches 0: between two
/// neighbouring extrema, which are roots of p', there is at most one root.
inline Roots real_roots(const Quartic& p, double low, double high, std::size_t degree = 4) {
  Roots roots;
  if (degree == 0) return roots;
  const Quartic slope = derivative_of(p);
  const Roots extrema = real_roots(slope, low, high, degree - 1);
  const double nearly = 1e-9;  // share of the terms' sizes; what rounding makes of a double root
  double from = low;
  const auto look_until = [&](double to) {
    if ((value_of(p, from) < 0.0) != (value_of(p, to) < 0.0)) {
      roots.add(root_between(p, slope, from, to));
    }
    from = to;
  };
  for (const double extremum : extrema) {
    double terms = 0.0;
    for (std::size_t i = p.size(); i-- > 0;) terms = terms * extremum + std::abs(p[i]);
    if (degree == 4 && std::abs(value_of(p, extremum)) <= nearly * terms) roots.add(extremum);
    look_until(extremum);
  }
  look_until(high);
  return roots;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
