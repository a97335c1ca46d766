// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/edges/knn_edges.hpp>

#include "catch.hpp"
#include "clique_consensus.hpp"
#include "fixed_tolerance_pairs.hpp"
#include "random_graphs.hpp"
#include "spectral_consensus.hpp"

namespace {

/// Pairs of which each two agree with this probability, but the first `planted` ones always.
Eigen::MatrixXd random_affinity(std::mt19937& random, Eigen::Index count, double density,
                                Eigen::Index planted) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Eigen::MatrixXd affinity = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (i < planted) {
        affinity(i, j) = affinity(j, i) = 0.9 + 0.1 * unit(random);
      } else if (unit(random) < density) {
        affinity(i, j) = affinity(j, i) = 0.1 + 0.9 * unit(random);
      }
    }
  }
  return affinity;
}

bool all_agree(const Eigen::MatrixXd& affinity, const std::vector<std::size_t>& chosen) {
  return std::all_of(chosen.begin(), chosen.end(), [&](std::size_t a) {
    return std::all_of(chosen.begin(), chosen.end(), [&](std::size_t b) {
      return affinity(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) > 0.0;
    });
  });
}

/// The size of the largest set that agrees, of all subsets.
std::size_t largest_by_trying_all(const Eigen::MatrixXd& affinity) {
  std::size_t largest = 0;
  for (unsigned set = 0; set < 1U << affinity.rows(); ++set) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < static_cast<std::size_t>(affinity.rows()); ++i) {
      if ((set >> i & 1U) != 0) chosen.push_back(i);
    }
    if (all_agree(affinity, chosen)) largest = std::max(largest, chosen.size());
  }
  return largest;
}

}  // namespace

TEST_CASE("the baselines' consensus is a set that agrees, the clique a largest one",
          "[benchmarks]") {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const Eigen::MatrixXd affinity =
        random_affinity(random, round % 11, 0.1 * (1 + round % 9), round % 4);
    const std::size_t largest = largest_by_trying_all(affinity);
    const CliqueConsensus clique(affinity);
    CHECK(clique.chosen().size() == largest);
    CHECK(all_agree(affinity, clique.chosen()));
    const auto spectral = spectral_consensus(affinity);
    CHECK(spectral.size() <= largest);
    CHECK(spectral.empty() == (largest == 0));
    CHECK(all_agree(affinity, spectral));
    CHECK(std::is_sorted(spectral.begin(), spectral.end()));
  }
}

TEST_CASE("both baselines find a consensus among as many strangers", "[benchmarks]") {
  std::mt19937 random(2);
  std::vector<std::size_t> planted;
  for (std::size_t i = 0; i < 12; ++i) planted.push_back(i);
  for (int round = 0; round < 30; ++round) {
    const Eigen::MatrixXd affinity = random_affinity(random, 40, 0.3, 12);
    CHECK(CliqueConsensus(affinity).chosen() == planted);
    CHECK(spectral_consensus(affinity) == planted);
  }
}

TEST_CASE("a moved graph's own pairs agree wholly at a fixed tolerance", "[benchmarks]") {
  std::mt19937 random(3);
  const auto nodes = random_nodes(random, 12, 3);
  auto moved = nodes;
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d::UnitY());
  for (auto& node : moved) node.position = turn * *node.position + Eigen::Vector3d(1, 2, 3);
  const auto graph = topobag::make_topology_graph(nodes, topobag::KnnEdges{3});
  const auto other = topobag::make_topology_graph(moved, topobag::KnnEdges{3});
  const auto pairs = same_class_pairs(graph, other);
  const Eigen::MatrixXd affinity = pair_affinity(graph, other, pairs, 0.05);
  CHECK(affinity == affinity.transpose());
  std::size_t own = 0, of_one_class = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    CHECK(nodes[pairs[i].candidate].label == moved[pairs[i].query].label);
    if (pairs[i].candidate != pairs[i].query) continue;
    ++own;
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      if (pairs[j].candidate != pairs[j].query) continue;
      CHECK(affinity(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) ==
            Approx(1.0).margin(1e-9));
    }
  }
  for (const auto& a : nodes) {
    for (const auto& b : nodes) of_one_class += a.label == b.label ? 1 : 0;
  }
  CHECK(own == nodes.size());
  CHECK(pairs.size() == of_one_class);
  CHECK(CliqueConsensus(affinity).chosen().size() >= nodes.size());
}
