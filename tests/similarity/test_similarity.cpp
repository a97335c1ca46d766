// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

#include <topobag/similarity/affinity_cosine.hpp>
#include <topobag/similarity/class_histogram.hpp>
#include <topobag/similarity/class_pair_distance_histogram.hpp>
#include <topobag/similarity/class_triangles.hpp>
#include <topobag/similarity/label_walks.hpp>
#include <topobag/similarity/padded_cosine.hpp>
#include <topobag/similarity/semantic_subgraph.hpp>
#include <topobag/similarity/similarity.hpp>
#include <topobag/similarity/surrounding_labels.hpp>
#include <topobag/similarity/weisfeiler_lehman.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

namespace {

using Graph = TopologyGraph<double>;

struct SortedPaddedCosine : PaddedCosine {
  SortedPaddedCosine() { row_order = RowOrder::class_then_position; }
};

struct AssignedPaddedCosine : PaddedCosine {
  AssignedPaddedCosine() { row_order = RowOrder::assignment; }
};

struct CosineClassHistogram : ClassHistogram {
  CosineClassHistogram() { measure = HistogramMeasure::cosine; }
};

struct NeighborPairs : SurroundingLabels {
  NeighborPairs() { counted = Surroundings::neighbor_pairs; }
};

/// Class vectors with negative cosines among them, and weights.
struct VectorAffinityCosine : AffinityCosine {
  VectorAffinityCosine() {
    vectors.set(ClassId{1}, Eigen::Vector2d(1.0, 0.2));
    vectors.set(ClassId{2}, Eigen::Vector2d(-1.0, 0.1));
    weights.set(ClassId{3}, 3.0);
  }
};

struct NotASimilarity {
  int operator()(int) const { return 0; }
};

static_assert(!is_similarity_v<NotASimilarity, Graph>);
static_assert(!has_descriptor_v<NotASimilarity, Graph>);
static_assert(std::is_same_v<descriptor_t<ClassPairDistanceHistogram, Graph>, SparseHistogram>);

/// Random graphs of all small sizes, some with unplaced nodes, some without edges.
std::vector<Graph> sample(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Graph> graphs;
  for (std::size_t n = 1; n <= 12; ++n) {
    graphs.push_back(random_graph(random, n));
    graphs.push_back(random_graph(random, n, 3, false));
    graphs.emplace_back(random_nodes(random, n, 2));
  }
  return graphs;
}

TopologyGraph<float> in_floats(const Graph& graph) {
  std::vector<SemanticNode<float>> nodes(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const SemanticNode<>& node = graph.nodes()[i];
    nodes[i].label = node.label;
    if (node.pixel) nodes[i].pixel = node.pixel->cast<float>();
    if (node.position) nodes[i].position = node.position->cast<float>();
    nodes[i].z = static_cast<float>(node.z);
    nodes[i].size = node.size.cast<float>();
  }
  return TopologyGraph<float>(std::move(nodes), graph.edges());
}

}  // namespace

TEST_CASE("a lambda on two graphs is a similarity", "[similarity]") {
  const auto nodes_in_common = [](const Graph& p, const Graph& q) {
    return static_cast<double>(std::min(p.size(), q.size()));
  };
  STATIC_REQUIRE(is_similarity_v<decltype(nodes_in_common), Graph>);
  STATIC_REQUIRE_FALSE(has_descriptor_v<decltype(nodes_in_common), Graph>);
  CHECK(nodes_in_common(Graph{}, Graph{}) == 0.0);
}

#define TOPOBAG_TEST_SIMILARITIES                                                               \
  PaddedCosine, SortedPaddedCosine, AssignedPaddedCosine, AffinityCosine, VectorAffinityCosine, \
      ClassHistogram, CosineClassHistogram, ClassPairDistanceHistogram, ClassTriangles,         \
      LabelWalks, SemanticSubgraph, SurroundingLabels, NeighborPairs, WeisfeilerLehman

TEMPLATE_TEST_CASE("laws of a similarity", "[similarity]", TOPOBAG_TEST_SIMILARITIES) {
  const TestType similarity;
  STATIC_REQUIRE(is_similarity_v<TestType, Graph>);
  STATIC_REQUIRE(is_similarity_v<TestType, TopologyGraph<float>>);
  STATIC_REQUIRE(has_descriptor_v<TestType, Graph>);

  const std::vector<Graph> graphs = sample(1);
  for (const Graph& p : graphs) {
    CHECK(similarity(p, p) == Approx(1.0).epsilon(1e-12));
    CHECK(similarity(p, Graph{}) == 0.0);
    CHECK(similarity(Graph{}, p) == 0.0);
    for (const Graph& q : graphs) {
      const double s = similarity(p, q);
      CHECK(s >= 0.0);
      CHECK(s <= 1.0);
      CHECK(similarity(q, p) == s);
      CHECK(similarity.similarity(similarity.descriptor(p), similarity.descriptor(q)) == s);
    }
  }
  CHECK(similarity(Graph{}, Graph{}) == 0.0);
}

TEMPLATE_TEST_CASE("the order of the nodes does not change the last bit", "[similarity]",
                   AffinityCosine, VectorAffinityCosine, ClassHistogram, CosineClassHistogram,
                   ClassPairDistanceHistogram, ClassTriangles, LabelWalks, SemanticSubgraph,
                   SurroundingLabels, NeighborPairs, WeisfeilerLehman) {
  const TestType similarity;
  std::mt19937 random(2);
  const std::vector<Graph> graphs = sample(3);
  for (const Graph& p : graphs) {
    const Graph shuffled = permuted(p, random_order(random, p.size()));
    for (const Graph& q : graphs) CHECK(similarity(shuffled, q) == similarity(p, q));
  }
}

TEMPLATE_TEST_CASE("the repaired row orders do not depend on the nodes'", "[similarity]",
                   SortedPaddedCosine, AssignedPaddedCosine) {
  const TestType similarity;
  std::mt19937 random(2);
  const std::vector<Graph> graphs = sample(3);
  for (const Graph& p : graphs) {
    const Graph shuffled = permuted(p, random_order(random, p.size()));
    for (const Graph& q : graphs) {
      CHECK(std::abs(similarity(shuffled, q) - similarity(p, q)) < 1e-12);
    }
  }
}

TEMPLATE_TEST_CASE("the camera's motion does not matter", "[similarity]", AffinityCosine,
                   ClassHistogram, ClassPairDistanceHistogram, ClassTriangles, LabelWalks,
                   SemanticSubgraph, SurroundingLabels, WeisfeilerLehman) {
  const TestType similarity;
  const Eigen::Isometry3d T = Eigen::Translation3d(0.3, -1.0, 2.0) *
                              Eigen::AngleAxisd(0.8, Eigen::Vector3d(1.0, 2.0, -1.0).normalized());
  for (const Graph& p : sample(4)) {
    std::vector<SemanticNode<>> nodes = p.nodes();
    for (SemanticNode<>& node : nodes) {
      if (node.position) node.position = T * *node.position;
      node.pixel.reset();
    }
    CHECK(similarity(p, Graph(nodes, p.edges())) == Approx(1.0).epsilon(1e-9));
  }
}

TEMPLATE_TEST_CASE("graphs without a class in common have nothing in common", "[similarity]",
                   AssignedPaddedCosine, AffinityCosine, ClassHistogram, CosineClassHistogram,
                   ClassPairDistanceHistogram, ClassTriangles, LabelWalks, SemanticSubgraph,
                   SurroundingLabels, NeighborPairs, WeisfeilerLehman) {
  const TestType similarity;
  std::mt19937 random(5);
  for (std::size_t n = 1; n < 10; ++n) {
    const Graph p = random_graph(random, n);
    std::vector<SemanticNode<>> nodes = p.nodes();
    for (SemanticNode<>& node : nodes) node.label = ClassId{value(node.label) + 100};
    CHECK(similarity(p, Graph(nodes, p.edges())) == 0.0);
  }
}

TEMPLATE_TEST_CASE("graphs of floats are as similar as those of doubles", "[similarity]",
                   TOPOBAG_TEST_SIMILARITIES) {
  const TestType similarity;
  const std::vector<Graph> graphs = sample(7);
  for (std::size_t i = 1; i < graphs.size(); ++i) {
    const Graph &p = graphs[i - 1], &q = graphs[i];
    CHECK(std::abs(similarity(in_floats(p), in_floats(q)) - similarity(p, q)) < 1e-4);
  }
}

TEMPLATE_TEST_CASE("coincident and far-off nodes give numbers", "[similarity]",
                   TOPOBAG_TEST_SIMILARITIES) {
  const TestType similarity;
  std::mt19937 random(6);
  auto nodes = random_nodes(random, 6, 2);
  nodes[1] = nodes[0];
  nodes[2].position = Eigen::Vector3d(1e300, -1e300, 1e300);
  nodes[3].position = Eigen::Vector3d(-1e300, 1e300, 1e300);
  const Graph p = make_topology_graph(nodes, KnnEdges{3});
  for (const Graph& q : {p, random_graph(random, 6), random_graph(random, 2)}) {
    const double s = similarity(p, q);
    CHECK(s >= 0.0);
    CHECK(s <= 1.0);
    CHECK(similarity(q, p) == s);
  }
}
