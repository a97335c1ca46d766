// SPDX-License-Identifier: MIT
// The snippets of examples/docs/from_dbow2.md.
#include <cstddef>
#include <string>
#include <vector>

#include <topobag/bag/bag_of_topology_graphs.hpp>
#include <topobag/bag/indexed_bag.hpp>
#include <topobag/bag/snapshot_file.hpp>
#include <topobag/matching/match_nodes.hpp>
#include <topobag/similarity/class_histogram.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"
#include "scratch_folder.hpp"

using namespace topobag;

namespace {

std::vector<TopologyGraph<>> graphs_of_a_drive() {
  std::mt19937 random(1);
  std::vector<TopologyGraph<>> graphs;
  for (int i = 0; i < 50; ++i) graphs.push_back(random_graph(random, 8, 5));
  return graphs;
}

}  // namespace

TEST_CASE("from DBoW2: add, query, find, erase", "[docs]") {
  const std::vector<TopologyGraph<>> graphs = graphs_of_a_drive();
  const TopologyGraph<>& graph = graphs[3];

  BagOfTopologyGraphs<> bag;
  for (std::size_t i = 0; i < graphs.size(); ++i) bag.add(KeyframeId{i}, graphs[i]);

  QueryOptions options;
  options.max_results = 4;                // the best four; DBoW2's default is one
  options.among.max_id = KeyframeId{29};  // that one included
  const std::vector<Candidate> best = bag.query(graph, options);
  CHECK(best.size() == 4);
  CHECK(best[0] == Candidate{KeyframeId{3}, 1.0});

  options.max_results = bag.size();    // all, as DBoW2's max_results <= 0
  options.min_similarity = 1e-9;       // none without anything in common
  options.exclude.id = KeyframeId{3};  // the query's own id,
  options.exclude.min_id_gap = 10;     // and its neighbours
  for (const Candidate& candidate : bag.query(graph, options)) {
    CHECK(value(candidate.id) >= 13);
    CHECK(value(candidate.id) <= 29);
    CHECK(candidate.similarity > 0.0);
  }

  bag.update(KeyframeId{3}, graphs[4]);
  bag.erase(KeyframeId{4});
  CHECK(bag.query(graphs[4]).front().id == KeyframeId{3});
  CHECK(bag.find(KeyframeId{3})->size() == graphs[4].size());
}

TEST_CASE("from DBoW2: score, weights, transform", "[docs]") {
  const std::vector<TopologyGraph<>> graphs = graphs_of_a_drive();
  const TopologyGraph<>&p = graphs[0], &q = graphs[1];

  const ClassPairDistanceHistogram similarity;
  const SparseHistogram words = similarity.descriptor(p);  // as voc.transform(features, v)
  const double score = similarity.similarity(words, similarity.descriptor(q));
  CHECK(score == similarity(p, q));
  CHECK(similarity(p, p) == 1.0);

  ClassHistogram tf_idf;
  tf_idf.measure = HistogramMeasure::cosine;
  tf_idf.weights = ClassWeights::idf(graphs);  // of other places than the map's
  BagOfTopologyGraphs<TopologyGraph<>, ClassHistogram> bag(tf_idf);
  bag.add(KeyframeId{0}, p);
  CHECK(bag.query(q).front().similarity == tf_idf(q, p));
}

TEST_CASE("from DBoW2: the direct index", "[docs]") {
  const std::vector<TopologyGraph<>> graphs = graphs_of_a_drive();
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{7}, graphs[0]);
  const TopologyGraph<>& query = graphs[0];

  const NodeMatching match = match_nodes(*bag.find(KeyframeId{7}), query);
  for (const Correspondence& pair : match.pairs) {
    CHECK(pair.candidate == pair.query);
  }
  CHECK(match.pairs.size() == query.size());
}

TEST_CASE("from DBoW2: save and load", "[docs]") {
  const ScratchFolder folder;
  const std::string path = folder.path("drive.bag");
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{7}, graphs_of_a_drive()[0]);

  save(bag, path);
  bag = load<BagOfTopologyGraphs<>>(path);
  CHECK(bag.contains(KeyframeId{7}));
}

TEST_CASE("from DBoW2: one adds while others ask", "[docs]") {
  const std::vector<TopologyGraph<>> graphs = graphs_of_a_drive();
  const TopologyGraph<>& graph = graphs[3];

  IndexedBag bag;
  for (std::size_t i = 0; i < graphs.size(); ++i) bag.add(KeyframeId{i}, graphs[i]);
  const auto view = bag.view();  // any thread, any number of them
  bag.erase(KeyframeId{3});
  CHECK(view->query(graph).front().id == KeyframeId{3});
  CHECK(bag.query(graph).front().id != KeyframeId{3});
}
