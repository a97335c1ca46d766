// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <topobag/graph/topology_graph.hpp>
#include <topobag/matching/consistency_graph.hpp>

/// All sets of one-to-one pairs that agree, one query node after the other: the reference.
class ExhaustiveSearch {
 public:
  ExhaustiveSearch(const topobag::TopologyGraph<>& candidate, const topobag::TopologyGraph<>& query,
                   const topobag::ConsistencyOptions& options)
      : candidate_(candidate), query_(query), options_(options) {
    choose(0);
  }

  std::size_t size() const { return size_; }
  double rms_difference() const { return rms_; }

  bool agree(const topobag::Correspondence& a, const topobag::Correspondence& b) const {
    if (a.query == b.query || a.candidate == b.candidate) return false;
    const double difference =
        std::abs(length(candidate_, a.candidate, b.candidate) - length(query_, a.query, b.query));
    if (difference <= options_.min_tolerance) return true;
    const double deviation = std::sqrt(variance(candidate_, a.candidate, b.candidate) +
                                       variance(query_, a.query, b.query));
    return difference <= std::min(options_.max_tolerance, options_.deviations * deviation);
  }

  bool may_pair(const topobag::Correspondence& pair) const {
    const auto& p = candidate_.node(pair.candidate);
    const auto& q = query_.node(pair.query);
    const double ratio = p.size.norm() / q.size.norm();
    return p.position && q.position && p.label == q.label && ratio <= options_.max_size_ratio &&
           1.0 / ratio <= options_.max_size_ratio;
  }

  double rms_of(const std::vector<topobag::Correspondence>& pairs) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double difference = length(candidate_, pairs[i].candidate, pairs[j].candidate) -
                                  length(query_, pairs[i].query, pairs[j].query);
        sum += difference * difference;
        ++count;
      }
    }
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
  }

 private:
  static double length(const topobag::TopologyGraph<>& graph, topobag::NodeIndex i,
                       topobag::NodeIndex j) {
    return (*graph.node(i).position - *graph.node(j).position).norm();
  }

  static double variance(const topobag::TopologyGraph<>& graph, topobag::NodeIndex i,
                         topobag::NodeIndex j) {
    const Eigen::Matrix3d covariance = graph.node(i).covariance + graph.node(j).covariance;
    const Eigen::Vector3d line = *graph.node(i).position - *graph.node(j).position;
    // Coincident nodes have no direction: the mean over all.
    if (line.isZero(0.0)) return covariance.trace() / 3.0;
    return line.normalized().dot(covariance * line.normalized());
  }

  void choose(std::size_t q) {
    if (chosen_.size() + (query_.size() - q) < size_) return;
    if (q == query_.size()) {
      const double rms = rms_of(chosen_);
      if (chosen_.size() > size_ || rms < rms_) rms_ = rms;
      size_ = std::max(size_, chosen_.size());
      return;
    }
    choose(q + 1);
    for (std::size_t p = 0; p < candidate_.size(); ++p) {
      const topobag::Correspondence pair{topobag::node_index(p), topobag::node_index(q)};
      if (!may_pair(pair)) continue;
      if (!std::all_of(chosen_.begin(), chosen_.end(),
                       [&](const topobag::Correspondence& other) { return agree(pair, other); })) {
        continue;
      }
      chosen_.push_back(pair);
      choose(q + 1);
      chosen_.pop_back();
    }
  }

  const topobag::TopologyGraph<>& candidate_;
  const topobag::TopologyGraph<>& query_;
  const topobag::ConsistencyOptions& options_;
  std::vector<topobag::Correspondence> chosen_;
  std::size_t size_ = 0;
  double rms_ = 0.0;
};
