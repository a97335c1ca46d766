// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <topobag/assert.hpp>
#include <topobag/version.hpp>

namespace topobag {
inline namespace v0 {

/// How many resamples, drawn how.
struct ResamplingOptions {
  std::size_t resamples = 1000;  ///< samples drawn
  std::uint64_t seed = 1;        ///< equal seeds give equal results on every machine
};

/// Calls `visit(multiplicity)` for every bootstrap resample of n units (queries: the pairs of one
/// query are not independent): how often each unit was drawn, n draws in all.
template <typename Visit>
void for_each_resample(std::size_t n, const ResamplingOptions& options, Visit&& visit) {
  TOPOBAG_ASSERT(n <= UINT32_MAX);
  std::mt19937_64 random(options.seed);
  std::vector<std::uint32_t> multiplicity(n);
  for (std::size_t i = 0; i < options.resamples; ++i) {
    std::fill(multiplicity.begin(), multiplicity.end(), 0);
    for (std::size_t k = 0; k < n; ++k) ++multiplicity[((random() >> 32) * n) >> 32];
    visit(multiplicity);
  }
}

/// The two ends of an interval.
struct ConfidenceInterval {
  double low = 0.0;   ///< lower end
  double high = 0.0;  ///< upper end
};

/// The central interval that holds `level` of the values, linear between neighbours; nothing of an
/// empty list. Precondition: 0 < level < 1.
inline std::optional<ConfidenceInterval> percentile_interval(std::vector<double> values,
                                                             double level = 0.95) {
  TOPOBAG_ASSERT(level > 0.0 && level < 1.0);
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) {
    const double at = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (at - std::floor(at)) * (values[above] - values[below]);
  };
  return ConfidenceInterval{quantile((1.0 - level) / 2.0), quantile((1.0 + level) / 2.0)};
}

/// A paired comparison of two methods, b against a.
struct PairedTest {
  double mean_difference = 0.0;  ///< of b − a
  double p_value = 1.0;          ///< two-sided, in (0, 1]
};

/// Paired randomization test on one value per unit and method (say, whether a query's first answer
/// was right): how often random exchanges of the two methods' values differ as much in the mean as
/// the methods do. Precondition: equal sizes. Without units the methods do not differ. The least
/// p-value is 1 / (resamples + 1). O(n · resamples).
inline PairedTest paired_test(const std::vector<double>& a, const std::vector<double>& b,
                              const ResamplingOptions& options = {}) {
  TOPOBAG_ASSERT(a.size() == b.size());
  std::vector<double> differences;
  double observed = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;  // an exchange changes nothing
    differences.push_back(b[i] - a[i]);
    observed += differences.back();
    size += std::abs(differences.back());
  }
  if (differences.empty()) return {};
  std::mt19937_64 random(options.seed);
  const double rounding = 1e-12 * size;
  std::size_t as_large = 1;
  for (std::size_t i = 0; i < options.resamples; ++i) {
    double sum = 0.0;
    for (const double difference : differences) {
      sum += (random() >> 63) != 0 ? difference : -difference;
    }
    if (std::abs(sum) >= std::abs(observed) - rounding) ++as_large;
  }
  return {observed / static_cast<double>(a.size()),
          static_cast<double>(as_large) / static_cast<double>(options.resamples + 1)};
}

}  // namespace v0
}  // namespace topobag
