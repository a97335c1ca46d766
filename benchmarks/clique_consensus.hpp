// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

/// A largest set of pairs of which no two contradict each other: the maximum clique by which
/// TEASER++ throws outliers out (H. Yang, J. Shi, L. Carlone, "TEASER: fast and certifiable point
/// cloud registration", 2020). Ours, and plain: branch and bound by greedy colouring. Exponential
/// in the worst case; cut off after `max_steps`.
class CliqueConsensus {
 public:
  /// @param affinity  zero where two pairs contradict each other
  explicit CliqueConsensus(const Eigen::MatrixXd& affinity, std::size_t max_steps = 200000)
      : affinity_(affinity), steps_left_(max_steps) {
    std::vector<Eigen::Index> all;
    for (Eigen::Index i = 0; i < affinity.rows(); ++i) all.push_back(i);
    grow(all);
    for (const Eigen::Index i : best_) chosen_.push_back(static_cast<std::size_t>(i));
    std::sort(chosen_.begin(), chosen_.end());
  }
  CliqueConsensus(const CliqueConsensus&) = delete;
  CliqueConsensus& operator=(const CliqueConsensus&) = delete;

  /// Indices of the pairs, ascending.
  const std::vector<std::size_t>& chosen() const { return chosen_; }

 private:
  bool agree(Eigen::Index a, Eigen::Index b) const { return affinity_(a, b) > 0.0; }

  /// Each with the number of colours that it and those before it need: no larger clique is there.
  std::vector<std::pair<Eigen::Index, std::size_t>> colored(
      const std::vector<Eigen::Index>& open) const {
    std::vector<std::vector<Eigen::Index>> classes;
    for (const Eigen::Index i : open) {
      const auto free = std::find_if(classes.begin(), classes.end(), [&](const auto& members) {
        return std::none_of(members.begin(), members.end(),
                            [&](Eigen::Index other) { return agree(i, other); });
      });
      if (free == classes.end()) {
        classes.push_back({i});
      } else {
        free->push_back(i);
      }
    }
    std::vector<std::pair<Eigen::Index, std::size_t>> order;
    for (std::size_t color = 0; color < classes.size(); ++color) {
      for (const Eigen::Index i : classes[color]) order.emplace_back(i, color + 1);
    }
    return order;
  }

  void grow(const std::vector<Eigen::Index>& open) {
    auto order = colored(open);
    while (!order.empty()) {
      if (steps_left_ == 0 || taken_.size() + order.back().second <= best_.size()) return;
      --steps_left_;
      const Eigen::Index next = order.back().first;
      order.pop_back();
      std::vector<Eigen::Index> rest;
      for (const auto& [i, color] : order) {
        if (agree(next, i)) rest.push_back(i);
      }
      taken_.push_back(next);
      if (taken_.size() > best_.size()) best_ = taken_;
      grow(rest);
      taken_.pop_back();
    }
  }

  const Eigen::MatrixXd& affinity_;
  std::size_t steps_left_;
  std::vector<Eigen::Index> taken_, best_;
  std::vector<std::size_t> chosen_;
};
