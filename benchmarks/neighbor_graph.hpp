// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

#ifdef TOPOBAG_HAS_HNSWLIB
#include <hnswlib/hnswlib.h>
#endif

#include <topobag/bag/query.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>

namespace bench {

#ifdef TOPOBAG_HAS_HNSWLIB

/// A histogram thrown into 256 dimensions by its words, square roots of the weights, length 1.
inline std::vector<float> vector_of(const topobag::SparseHistogram& histogram) {
  std::vector<float> vector(256, 0.0F);
  for (const auto& entry : histogram.entries()) {
    vector[entry.word % 256] += static_cast<float>(entry.weight);
  }
  float norm = 0.0F;
  for (float& x : vector) norm += x;
  for (float& x : vector) x = std::sqrt(x / std::max(norm, 1e-9F));
  return vector;
}

/// The time of hnswlib (M = 16, ef 200 both ways) on vectors of the same graphs, and how many of
/// the exact answers it finds.
inline void compare_neighbor_graph(const std::vector<topobag::SparseHistogram>& stored,
                                   const topobag::ClassPairDistanceHistogram& similarity,
                                   const std::vector<topobag::TopologyGraph<>>& queries,
                                   const std::vector<std::vector<topobag::Candidate>>& answers) {
  using Clock = std::chrono::steady_clock;
  hnswlib::InnerProductSpace space(256);
  hnswlib::HierarchicalNSW<float> index(&space, stored.size(), 16, 200, 1);
  const auto build_start = Clock::now();
  for (std::size_t i = 0; i < stored.size(); ++i) index.addPoint(vector_of(stored[i]).data(), i);
  const std::chrono::duration<double, std::micro> build = Clock::now() - build_start;
  index.setEf(200);
  std::vector<double> us;
  std::size_t found = 0, wanted = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto start = Clock::now();
    auto nearest = index.searchKnn(vector_of(similarity.descriptor(queries[i])).data(), 10);
    us.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
    wanted += answers[i].size();
    for (; !nearest.empty(); nearest.pop()) {
      const auto id = static_cast<std::uint64_t>(nearest.top().second);
      found += static_cast<std::size_t>(
          std::count_if(answers[i].begin(), answers[i].end(),
                        [&](const topobag::Candidate& c) { return value(c.id) == id; }));
    }
  }
  std::nth_element(us.begin(), us.begin() + static_cast<std::ptrdiff_t>(us.size() / 2), us.end());
  std::printf(
      "{\"bench\":\"bag_hnswlib\",\"graphs\":%zu,\"median_us\":%.1f,\"recall\":%.3f,"
      "\"add_us\":%.2f}\n",
      stored.size(), us[us.size() / 2], static_cast<double>(found) / static_cast<double>(wanted),
      build.count() / static_cast<double>(stored.size()));
}

#else

inline void compare_neighbor_graph(const std::vector<topobag::SparseHistogram>&,
                                   const topobag::ClassPairDistanceHistogram&,
                                   const std::vector<topobag::TopologyGraph<>>&,
                                   const std::vector<std::vector<topobag::Candidate>>&) {}

#endif

}  // namespace bench
