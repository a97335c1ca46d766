// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bench {

/// The value below which a share of the values lies.
inline double share(std::vector<double> values, double quantile) {
  const auto at = static_cast<std::ptrdiff_t>(quantile * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Of values that are not none.
inline double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The least of three times that `call()` takes, µs.
template <typename Call>
double least_time(const Call& call) {
  double least = 0.0;
  for (int repeat = 0; repeat < 3; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    call();
    const std::chrono::duration<double, std::micro> elapsed =
        std::chrono::steady_clock::now() - start;
    if (repeat == 0 || elapsed.count() < least) least = elapsed.count();
  }
  return least;
}

/// Up to `max_pairs` pairs of so many map graphs and queries, evenly spread over all.
inline std::vector<std::pair<std::size_t, std::size_t>> spread_pairs(std::size_t map,
                                                                     std::size_t queries,
                                                                     std::size_t max_pairs) {
  const std::size_t all = map * queries;
  if (all == 0) throw std::runtime_error("no key frame has that many objects with a depth");
  const std::size_t step = std::max<std::size_t>(1, (all + max_pairs - 1) / max_pairs);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < all; i += step) pairs.emplace_back(i % map, i / map);
  return pairs;
}

/// Times of `call(candidate, query)` in µs for such pairs.
template <typename Graph, typename Call>
std::vector<double> times_of(const std::vector<Graph>& map, const std::vector<Graph>& queries,
                             std::size_t max_pairs, const Call& call) {
  std::vector<double> times;
  for (const auto& pair : spread_pairs(map.size(), queries.size(), max_pairs)) {
    times.push_back(least_time([&] { call(map[pair.first], queries[pair.second]); }));
  }
  return times;
}

/// A row of the table and a JSON line. @return the median
inline double print(const char* what, std::size_t nodes, const std::vector<double>& times) {
  const double median = share(times, 0.5);
  std::printf("%-38s %5zu %7zu %10.2f %10.2f %10.2f\n", what, nodes, times.size(), median,
              share(times, 0.99), mean(times));
  std::printf(
      "{\"bench\":\"matching\",\"what\":\"%s\",\"nodes\":%zu,\"pairs\":%zu,\"median_us\":%.3f,"
      "\"p99_us\":%.3f,\"mean_us\":%.3f}\n",
      what, nodes, times.size(), median, share(times, 0.99), mean(times));
  return median;
}

}  // namespace bench
