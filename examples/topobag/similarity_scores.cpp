// SPDX-License-Identifier: MIT
#include "similarity_scores.hpp"

#include <cstddef>
#include <utility>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/matching/consistency_similarity.hpp>
#include <topobag/similarity/affinity_cosine.hpp>
#include <topobag/similarity/class_histogram.hpp>
#include <topobag/similarity/class_triangles.hpp>
#include <topobag/similarity/label_walks.hpp>
#include <topobag/similarity/padded_cosine.hpp>
#include <topobag/similarity/semantic_subgraph.hpp>
#include <topobag/similarity/similarity.hpp>
#include <topobag/similarity/surrounding_labels.hpp>
#include <topobag/similarity/weisfeiler_lehman.hpp>

#include "stopwatch.hpp"

namespace program {
namespace {

using Graph = topobag::TopologyGraph<>;

template <typename Similarity>
auto descriptors_of(const Similarity& similarity, const std::vector<Keyframe>& keyframes) {
  std::vector<topobag::descriptor_t<Similarity, Graph>> descriptors;
  descriptors.reserve(keyframes.size());
  for (const Keyframe& keyframe : keyframes) {
    descriptors.push_back(similarity.descriptor(keyframe.graph));
  }
  return descriptors;
}

template <typename Similarity>
SimilarityScores score_by(const Similarity& similarity, std::string name, std::string meaning,
                          const std::vector<Keyframe>& queries, const std::vector<Keyframe>& map) {
  SimilarityScores result{std::move(name), std::move(meaning), {}, 0.0};
  result.scores.resize(static_cast<Eigen::Index>(queries.size()),
                       static_cast<Eigen::Index>(map.size()));
  const Stopwatch watch;
  const auto of_queries = descriptors_of(similarity, queries);
  const auto of_map = descriptors_of(similarity, map);
  double* score = result.scores.data();
  for (const auto& query : of_queries) {
    for (const auto& candidate : of_map) *score++ = similarity.similarity(candidate, query);
  }
  const double milliseconds = watch.milliseconds();
  result.pair_us = 1e3 * milliseconds / static_cast<double>(result.scores.size());
  return result;
}

}  // namespace

SimilarityScores score_padded_cosine(const std::vector<Keyframe>& queries,
                                     const std::vector<Keyframe>& map) {
  return score_by(topobag::PaddedCosine{}, "padded cosine", "the paper's eq. 12, detector's order",
                  queries, map);
}

SimilarityScores score_by_bag(const std::vector<Keyframe>& queries,
                              const std::vector<Keyframe>& map) {
  return score_by(topobag::BagOfTopologyGraphs<>::Similarity{}, "class pairs x distance",
                  "the bag's own retrieval", queries, map);
}

std::vector<SimilarityScores> score_similarities(const std::vector<Keyframe>& queries,
                                                 const std::vector<Keyframe>& map) {
  using namespace topobag;
  std::vector<Graph> background;
  for (const Keyframe& keyframe : map) background.push_back(keyframe.graph);
  const ClassWeights idf = ClassWeights::idf(background);

  std::vector<SimilarityScores> all{score_padded_cosine(queries, map)};
  const auto add = [&](const char* name, const char* meaning, const auto& similarity) {
    all.push_back(score_by(similarity, name, meaning, queries, map));
  };
  add("sorted rows", "eq. 12, rows sorted by class and place",
      PaddedCosine{RowOrder::class_then_position});
  add("assigned rows", "eq. 12, rows assigned within their class",
      PaddedCosine{RowOrder::assignment});
  add("affinity cosine", "eq. 12 repaired: e^(-d/sigma), one-hot classes, assigned rows",
      AffinityCosine{});
  add("class counts, cosine", "bag of objects", ClassHistogram{HistogramMeasure::cosine, {}});
  add("class counts, Jaccard", "bag of objects", ClassHistogram{});
  add("class counts, tf-idf", "bag of objects, weights learnt from the map",
      ClassHistogram{HistogramMeasure::cosine, idf});
  all.push_back(score_by_bag(queries, map));
  add("class triangles", "STD with classes at the corners", ClassTriangles{});
  add("label walks", "X-View, the paper's [24]", LabelWalks{});
  SurroundingLabels pairs;
  pairs.counted = Surroundings::neighbor_pairs;
  add("neighbour labels", "GOReloc", SurroundingLabels{});
  add("neighbour label pairs", "Semantic Histogram", pairs);
  add("Weisfeiler-Lehman", "subtree kernel", WeisfeilerLehman{});
  add("semantic sub-graph", "box shape and distances, the paper's [25]", SemanticSubgraph{});
  add("geometric consistency", "objects that lie alike", ConsistencySimilarity{});
  return all;
}

}  // namespace program
