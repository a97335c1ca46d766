// SPDX-License-Identifier: MIT
// A researcher's similarity: in a bag of its own, behind the library's geometry, beside the default.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>

#include <topobag/edges/knn_edges.hpp>
#include <topobag/recognition/relocalizer.hpp>

using namespace topobag;

namespace {

/// How many edges join the same two classes at a like length in both graphs.
struct EdgeOverlap {
  using Descriptor = std::map<std::pair<std::pair<ClassId, ClassId>, int>, int>;

  Descriptor descriptor(const TopologyGraph<>& graph) const {
    Descriptor counts;
    for (std::size_t i = 0; i < graph.edges().size(); ++i) {
      const auto& [a, b] = graph.edges()[i];
      const ClassId one = graph.node(a).label, other = graph.node(b).label;
      ++counts[{std::minmax(one, other), static_cast<int>(graph.lengths()[i] / 0.25)}];
    }
    return counts;
  }
  double similarity(const Descriptor& a, const Descriptor& b) const {
    int common = 0, all = 0;
    for (const auto& [key, count] : a) {
      const auto there = b.find(key);
      if (there != b.end()) common += std::min(count, there->second);
      all += count;
    }
    for (const auto& entry : b) all += entry.second;
    return all == 0 ? 0.0 : 2.0 * common / all;
  }
  double operator()(const TopologyGraph<>& a, const TopologyGraph<>& b) const {
    return similarity(descriptor(a), descriptor(b));
  }
};

/// A room of nine things, seen with 1 cm of noise from the same place.
TopologyGraph<> room(unsigned number, unsigned visit) {
  std::mt19937 layout(number), noise(100 * number + visit);
  std::uniform_real_distribution<double> metres(-1.5, 1.5), size(0.2, 0.8);
  std::normal_distribution<double> centimetre(0.0, 0.01);
  std::vector<SemanticNode<>> nodes(9);
  for (SemanticNode<>& node : nodes) {
    node.label = ClassId{static_cast<std::int32_t>(layout() % 8)};
    const double x = metres(layout), y = metres(layout), z = metres(layout);
    node.size = Eigen::Vector2d(size(layout), size(layout));
    node.position = Eigen::Vector3d(x + centimetre(noise), 0.5 * y + centimetre(noise),
                                    4.0 + z + centimetre(noise));
    node.covariance = 2e-4 * Eigen::Matrix3d::Identity();
  }
  return make_topology_graph(std::move(nodes), KnnEdges{});
}

template <typename Bag>
unsigned rooms_found() {
  Relocalizer<Bag> relocalizer;
  for (unsigned i = 0; i < 30; ++i) relocalizer.map().add(KeyframeId{i}, room(i, 0));
  unsigned found = 0;
  for (unsigned i = 0; i < 30; ++i) {
    const Recognition answer = relocalizer.localize(room(i, 1));
    if (answer && answer.accepted->id == KeyframeId{i}) ++found;
  }
  return found;
}

}  // namespace

int main() {
  const unsigned ours = rooms_found<BagOfTopologyGraphs<TopologyGraph<>, EdgeOverlap>>();
  const unsigned theirs = rooms_found<BagOfTopologyGraphs<>>();
  std::cout << "of 30 rooms found: " << ours << ", by the default " << theirs << '\n';
  return std::min(ours, theirs) >= 25 ? EXIT_SUCCESS : EXIT_FAILURE;
}
