// SPDX-License-Identifier: MIT
#include <topobag/similarity/class_pair_distance_histogram.hpp>
#include <topobag/similarity/padded_cosine.hpp>
#include <topobag/similarity/similarity.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

struct NotASimilarity {
  int operator()(int) const { return 0; }
};

using Graph = TopologyGraph<double>;

static_assert(is_similarity_v<PaddedCosine, Graph>);
static_assert(is_similarity_v<ClassPairDistanceHistogram, Graph>);
static_assert(has_descriptor_v<ClassPairDistanceHistogram, TopologyGraph<float>>);
static_assert(std::is_same_v<descriptor_t<ClassPairDistanceHistogram, Graph>, SparseHistogram>);
static_assert(!is_similarity_v<NotASimilarity, Graph>);
static_assert(!has_descriptor_v<NotASimilarity, Graph>);

}  // namespace

TEST_CASE("a lambda on two graphs is a similarity", "[similarity]") {
  const auto nodes_in_common = [](const Graph& p, const Graph& q) {
    return static_cast<double>(std::min(p.size(), q.size()));
  };
  STATIC_REQUIRE(is_similarity_v<decltype(nodes_in_common), Graph>);
  STATIC_REQUIRE_FALSE(has_descriptor_v<decltype(nodes_in_common), Graph>);
  CHECK(nodes_in_common(Graph{}, Graph{}) == 0.0);
}
