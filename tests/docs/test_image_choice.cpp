// SPDX-License-Identifier: MIT
// The image's descriptor of examples/docs/choosing.md.
#include <random>

#include <Eigen/Core>

#include <topobag/recognition/relocalizer.hpp>

#include "catch.hpp"
#include "random_graphs.hpp"

using namespace topobag;

TEST_CASE("a page's image descriptor decides which of two like places comes first", "[docs]") {
  std::mt19937 random(1);
  const TopologyGraph<> graph = random_graph(random, 8);
  const Eigen::VectorXd vector = Eigen::VectorXd::Random(8448);
  const Eigen::VectorXd seen_vector = vector + 0.5 * Eigen::VectorXd::Random(8448);
  EntryInfo info;
  const ImageKind network("MegaLoc, 224 x 224", 8448);
  info.image = ImageDescriptor(network, vector);  // of a key frame that is added
  EntryInfo elsewhere;
  elsewhere.image = ImageDescriptor(network, Eigen::VectorXd::Random(8448));
  BagOfTopologyGraphs<> bag;
  bag.add(KeyframeId{1}, graph, elsewhere);
  bag.add(KeyframeId{2}, graph, info);
  bag.add(KeyframeId{3}, graph);
  RecognitionOptions options;
  options.retrieval.image.query = ImageDescriptor(network, seen_vector);
  CHECK(bag.query(graph, options.retrieval).front().id == KeyframeId{1});
  options.retrieval.image.min_similarity = 0.3;  // a gate: what is less like is not asked
  CHECK(bag.query(graph, options.retrieval).front().id == KeyframeId{2});
  CHECK(bag.query(graph, options.retrieval).size() == 2);
  options.retrieval.image.weight = 0.4;  // a share of the score
  const Recognition found = Relocalizer(bag, options).localize(graph);
  REQUIRE(found.candidates.size() == 2);
  CHECK(bag.query(graph, options.retrieval).back().similarity ==
        Approx(0.6 + 0.4 * cosine_similarity(info.image, options.retrieval.image.query)));
}
