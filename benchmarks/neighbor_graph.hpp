// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#ifdef TOPOBAG_HAS_FAISS
#include <faiss/IndexHNSW.h>
#include <omp.h>
#endif
#ifdef TOPOBAG_HAS_HNSWLIB
#include <hnswlib/hnswlib.h>
#endif

#include <topobag/bag/query.hpp>
#include <topobag/graph/topology_graph.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>

/// Approximate neighbour graphs (M = 16, ef 200 both ways, one thread) on vectors of the same
/// graphs: their time, and how many of the exact answers they find.
namespace bench {

constexpr std::size_t dimensions = 256;
constexpr std::size_t neighbors = 10;
constexpr int links = 16, effort = 200;

/// A histogram thrown into few dimensions by its words, square roots of the weights, length 1.
inline std::vector<float> vector_of(const topobag::SparseHistogram& histogram) {
  std::vector<float> vector(dimensions, 0.0F);
  for (const auto& entry : histogram.entries()) {
    vector[entry.word % dimensions] += static_cast<float>(entry.weight);
  }
  float norm = 0.0F;
  for (float& x : vector) norm += x;
  for (float& x : vector) x = std::sqrt(x / std::max(norm, 1e-9F));
  return vector;
}

#ifdef TOPOBAG_HAS_HNSWLIB
class Hnswlib {
 public:
  static constexpr const char* name = "hnswlib";
  explicit Hnswlib(std::size_t capacity) : index_(&space_, capacity, links, effort, 1) {
    index_.setEf(effort);
  }
  void add(const std::vector<float>& vector) { index_.addPoint(vector.data(), size_++); }
  std::vector<std::uint64_t> nearest(const std::vector<float>& vector) {
    std::vector<std::uint64_t> ids;
    auto found = index_.searchKnn(vector.data(), neighbors);
    for (; !found.empty(); found.pop()) ids.push_back(found.top().second);
    return ids;
  }

 private:
  hnswlib::InnerProductSpace space_{dimensions};
  hnswlib::HierarchicalNSW<float> index_;
  std::size_t size_ = 0;
};
#endif

#ifdef TOPOBAG_HAS_FAISS
class Faiss {
 public:
  static constexpr const char* name = "faiss";
  explicit Faiss(std::size_t) : index_(dimensions, links, faiss::METRIC_INNER_PRODUCT) {
    omp_set_num_threads(1);
    index_.hnsw.efConstruction = effort;
    index_.hnsw.efSearch = effort;
  }
  void add(const std::vector<float>& vector) { index_.add(1, vector.data()); }
  std::vector<std::uint64_t> nearest(const std::vector<float>& vector) {
    std::vector<float> scores(neighbors);
    std::vector<faiss::Index::idx_t> ids(neighbors);
    index_.search(1, vector.data(), neighbors, scores.data(), ids.data());
    return {ids.begin(), ids.end()};
  }

 private:
  faiss::IndexHNSWFlat index_;
};
#endif

template <typename Index>
void compare_with(const std::vector<topobag::SparseHistogram>& stored,
                  const topobag::ClassPairDistanceHistogram& similarity,
                  const std::vector<topobag::TopologyGraph<>>& queries,
                  const std::vector<std::vector<topobag::Candidate>>& answers) {
  using Clock = std::chrono::steady_clock;
  const auto us_since = [](Clock::time_point start) {
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
  };
  Index index(stored.size());
  const auto build_start = Clock::now();
  for (const auto& histogram : stored) index.add(vector_of(histogram));
  const double add_us = us_since(build_start) / static_cast<double>(stored.size());
  std::vector<double> us;
  std::size_t found = 0, wanted = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto start = Clock::now();
    const auto nearest = index.nearest(vector_of(similarity.descriptor(queries[i])));
    us.push_back(us_since(start));
    wanted += answers[i].size();
    for (const topobag::Candidate& answer : answers[i]) {
      found += static_cast<std::size_t>(
          std::count(nearest.begin(), nearest.end(), static_cast<std::uint64_t>(answer.id)));
    }
  }
  std::nth_element(us.begin(), us.begin() + static_cast<std::ptrdiff_t>(us.size() / 2), us.end());
  std::printf("%9s %11.0f us at the median; %.3f of the exact best %zu; %.0f us to add one\n",
              Index::name, us[us.size() / 2],
              static_cast<double>(found) / static_cast<double>(wanted), neighbors, add_us);
  std::printf(
      "{\"bench\":\"bag_%s\",\"graphs\":%zu,\"median_us\":%.1f,\"recall\":%.3f,"
      "\"add_us\":%.2f}\n",
      Index::name, stored.size(), us[us.size() / 2],
      static_cast<double>(found) / static_cast<double>(wanted), add_us);
}

/// With each that there is.
template <typename... Arguments>
void compare_neighbor_graphs([[maybe_unused]] const Arguments&... arguments) {
#ifdef TOPOBAG_HAS_HNSWLIB
  compare_with<Hnswlib>(arguments...);
#endif
#ifdef TOPOBAG_HAS_FAISS
  compare_with<Faiss>(arguments...);
#endif
}

}  // namespace bench
