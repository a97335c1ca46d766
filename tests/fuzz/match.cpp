// SPDX-License-Identifier: MIT
// Two small graphs: the largest consistent set is as large, and its distances as alike, as those of
// exhaustive search; every pose is finite, and its inliers are pairs.
#include <cmath>

#include <topobag/matching/match_graphs.hpp>

#include "fuzz/fuzz_input.hpp"
#include "matching/exhaustive_search.hpp"

namespace {

topobag::TopologyGraph<> graph_from(FuzzInput& input) {
  std::vector<topobag::SemanticNode<>> nodes(static_cast<std::size_t>(input.below(8)));
  for (auto& node : nodes) {
    node.label = topobag::ClassId{input.below(3)};
    // Steps of which no sum or ratio is just at a threshold, where rounding decides.
    node.position =
        0.0973 * Eigen::Vector3d(input.below(32), input.below(32), 10 + input.below(32));
    node.size = 0.1 * Eigen::Vector2d(1.13 + input.below(8), 1.13 + input.below(8));
    node.covariance = 1e-4 * (1 + input.below(64)) * Eigen::Matrix3d::Identity();
  }
  return topobag::TopologyGraph<>(nodes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  const auto candidate = graph_from(input), query = graph_from(input);
  const topobag::MatchNodesOptions options;
  const ExhaustiveSearch reference(candidate, query, options.consistency);
  const topobag::NodeMatching found = topobag::match_nodes(candidate, query, options);
  require(found.pairs.size() == reference.size(), "as many pairs as exhaustive search");
  require(std::abs(found.rms_difference - reference.rms_difference()) < 1e-9, "as alike");
  for (const auto& pose : topobag::match_graphs(candidate, query).poses) {
    require(pose.T_candidate_query.matrix().allFinite(), "a pose is finite");
    require(std::abs(pose.T_candidate_query.linear().determinant() - 1.0) < 1e-6, "a rotation");
    require(std::isfinite(pose.score()) && pose.covariance.allFinite(), "its score is finite");
    require(pose.inliers.size() >= 3, "three inliers");
    for (const auto& pair : pose.inliers) {
      require(candidate.node(pair.candidate).label == query.node(pair.query).label, "one class");
    }
  }
  return 0;
}
