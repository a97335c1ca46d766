// SPDX-License-Identifier: MIT
#include <algorithm>
#include <type_traits>

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
#include "similarity/laws.hpp"

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
  laws::check_definition(TestType{});
}

TEMPLATE_TEST_CASE("the order of the nodes does not change the last bit", "[similarity]",
                   AffinityCosine, VectorAffinityCosine, ClassHistogram, CosineClassHistogram,
                   ClassPairDistanceHistogram, ClassTriangles, LabelWalks, SemanticSubgraph,
                   SurroundingLabels, NeighborPairs, WeisfeilerLehman) {
  laws::check_node_order(TestType{});
}

TEMPLATE_TEST_CASE("the repaired row orders do not depend on the nodes'", "[similarity]",
                   SortedPaddedCosine, AssignedPaddedCosine) {
  laws::check_node_order(TestType{}, 1e-12);
}

TEMPLATE_TEST_CASE("the camera's motion does not matter", "[similarity]", AffinityCosine,
                   ClassHistogram, ClassPairDistanceHistogram, ClassTriangles, LabelWalks,
                   SemanticSubgraph, SurroundingLabels, WeisfeilerLehman) {
  laws::check_motion(TestType{});
}

TEMPLATE_TEST_CASE("graphs without a class in common have nothing in common", "[similarity]",
                   AssignedPaddedCosine, AffinityCosine, ClassHistogram, CosineClassHistogram,
                   ClassPairDistanceHistogram, ClassTriangles, LabelWalks, SemanticSubgraph,
                   SurroundingLabels, NeighborPairs, WeisfeilerLehman) {
  laws::check_foreign_classes(TestType{});
}

TEMPLATE_TEST_CASE("graphs of floats are as similar as those of doubles", "[similarity]",
                   TOPOBAG_TEST_SIMILARITIES) {
  laws::check_floats(TestType{});
}

TEMPLATE_TEST_CASE("coincident and far-off nodes give numbers", "[similarity]",
                   TOPOBAG_TEST_SIMILARITIES) {
  laws::check_extremes(TestType{});
}
