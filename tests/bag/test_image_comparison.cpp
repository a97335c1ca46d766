// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <topobag/bag/image_comparison.hpp>

#include "bag/described_images.hpp"
#include "bag/desk_pieces.hpp"
#include "bag/filled_bags.hpp"
#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

/// Key frames of places, with images; some are gone again, some have come back with others.
IndexedBag bag_with_images(std::mt19937& random, RecombinedGraphs& source, std::size_t places) {
  const IndexedBag plain = bag_of(source, places);
  IndexedBag bag;
  plain.for_each([&](KeyframeId id, EntryInfo info, const TopologyGraph<>& graph) {
    info.image = random_image(random);
    info.session = random() % 2;
    bag.add(id, graph, info);
  });
  for (std::uint64_t i = 0; i < 10 * places; i += 1 + random() % 5) {
    EntryInfo info;
    info.image = random_image(random);
    if (random() % 2 == 0) {
      bag.erase(KeyframeId{i});
    } else {
      bag.update(KeyframeId{i}, *bag.find(KeyframeId{i}), info);
    }
  }
  return bag;
}

/// By the rule as the header states it.
std::vector<Candidate> by_the_rule(const IndexedBag& bag, const TopologyGraph<>& graph,
                                   const QueryOptions& options) {
  std::vector<Candidate> found;
  const ImageComparison& image = options.image;
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& stored) {
    if (!options.among.contains(id, info)) return;
    double score = ClassPairDistanceHistogram{}(graph, stored);
    if (image.query.known() && info.image.known()) {
      const double cosine = cosine_similarity(image.query, info.image);
      if (cosine < image.min_similarity) return;
      if (image.weight > 0.0) {
        score = (1.0 - image.weight) * score + image.weight * std::max(0.0, cosine);
      }
    }
    if (score >= options.min_similarity) found.push_back({id, score});
  });
  std::sort(found.begin(), found.end());
  found.resize(std::min(found.size(), options.max_results));
  return found;
}

}  // namespace

TEST_CASE("images as a gate and in the score: every bag answers as the rule says, to the last bit",
          "[bag][index]") {
  std::mt19937 random(5);
  RecombinedGraphs source(desk_pieces(5), 5);
  const IndexedBag bag = bag_with_images(random, source, 60);
  const BruteForceBag all = brute_force_of(bag);
  BagOfTopologyGraphs<> lists;
  bag.for_each([&](KeyframeId id, const EntryInfo& info, const TopologyGraph<>& graph) {
    lists.add(id, graph, info);
  });
  CHECK(bag.image_kind() == test_image_kind());
  CHECK(lists.image_kind() == test_image_kind());
  std::size_t different = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const TopologyGraph<> graph =
        trial % 3 == 0 ? source.keyframe(source.place())
                       : *bag.find(bag.query(source.keyframe(source.place())).front().id);
    QueryOptions options;
    options.image.query = random_image(random);
    options.image.weight = std::vector<double>{0.0, 0.2, 0.6, 1.0}[random() % 4];
    options.image.min_similarity = std::vector<double>{-1.0, 0.0, 0.5}[random() % 3];
    options.min_similarity = std::vector<double>{0.0, 0.3, 0.8}[random() % 3];
    options.max_results = 1 + random() % 30;
    if (random() % 3 == 0) options.among.sessions = {1};
    const std::vector<Candidate> expected = by_the_rule(bag, graph, options);
    CAPTURE(trial, options.image.weight, options.image.min_similarity, options.min_similarity);
    CHECK(bag.query(graph, options) == expected);
    CHECK(all.query(graph, options) == expected);
    CHECK(lists.query(graph, options) == expected);
    QueryOptions without = options;
    without.image = {};
    if (bag.query(graph, without) != expected) ++different;
  }
  CHECK(different > 40);
}

TEST_CASE("a search with images reads few graphs, and says what it missed on a budget",
          "[bag][index]") {
  std::mt19937 random(6);
  RecombinedGraphs source(desk_pieces(6), 6);
  const IndexedBag bag = bag_with_images(random, source, 100);
  std::size_t read = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const TopologyGraph<> graph = source.keyframe(source.place());
    QueryOptions options;
    while (!options.image.query.known()) options.image.query = random_image(random);
    options.image.weight = 0.5;
    const SearchResult whole = bag.view()->search(graph, options);
    CHECK(whole.exact);
    CHECK(whole.candidates == by_the_rule(bag, graph, options));
    read += whole.visited;
    const SearchResult part = bag.view()->search(graph, options, 5);
    CHECK(part.visited <= 5);
    for (const Candidate& candidate : whole.candidates) {
      const bool found = std::find(part.candidates.begin(), part.candidates.end(), candidate) !=
                         part.candidates.end();
      CHECK((found || candidate.similarity <= part.missed_similarity));
    }
  }
  CHECK(read < 20 * bag.size() / 2);
}

TEST_CASE("images of another kind, and weights that are none, are refused", "[bag]") {
  IndexedBag indexed;
  BagOfTopologyGraphs<> plain;
  const TopologyGraph<> graph;
  EntryInfo info, other;
  info.image = {test_image_kind(), Eigen::VectorXd::Ones(24)};
  other.image = {ImageKind("other", 24), Eigen::VectorXd::Ones(24)};
  indexed.add(KeyframeId{1}, graph, info);
  plain.add(KeyframeId{1}, graph, info);
  CHECK_THROWS_AS(indexed.add(KeyframeId{2}, graph, other), InvalidValue);
  CHECK_THROWS_AS(plain.add(KeyframeId{2}, graph, other), InvalidValue);
  CHECK_THROWS_AS(indexed.update(KeyframeId{1}, graph, other), InvalidValue);
  CHECK_THROWS_AS(plain.update(KeyframeId{1}, graph, other), InvalidValue);
  IndexedBag another;
  another.add(KeyframeId{7}, graph, other);
  CHECK_THROWS_AS(indexed.merge(another), InvalidValue);
  CHECK_THROWS_AS(plain.merge(another), InvalidValue);
  CHECK(indexed.size() == 1);
  CHECK(plain.size() == 1);
  indexed.add(KeyframeId{2}, graph);  // an image that nobody described
  indexed.compact();
  CHECK(indexed.info(KeyframeId{1})->image == info.image);
  CHECK_FALSE(indexed.info(KeyframeId{2})->image.known());
  QueryOptions options;
  options.image.query = other.image;
  CHECK(error_text([&] { indexed.query(graph, options); }).find("the query has an image's") == 0);
  CHECK(error_text([&] { plain.query(graph, options); }).find("the query has an image's") == 0);
  options.image.query = info.image;
  for (const double weight : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    options.image.weight = weight;
    CHECK_THROWS_AS(indexed.query(graph, options), InvalidValue);
    CHECK_THROWS_AS(plain.query(graph, options), InvalidValue);
  }
}

TEST_CASE("images stay with their key frames when bags are joined and poses move", "[bag][index]") {
  std::mt19937 random(8);
  RecombinedGraphs source(desk_pieces(8), 8);
  IndexedBag a = bag_with_images(random, source, 20), b = bag_with_images(random, source, 20);
  const auto ids = a.merge(b);
  CameraPoses poses;
  for (const auto& [theirs, ours] : ids) poses.emplace(ours, Eigen::Isometry3d::Identity());
  a.set_poses(poses);
  for (const auto& [theirs, ours] : ids) {
    CHECK(a.info(ours)->image == b.info(theirs)->image);
  }
  std::size_t described = 0;
  IndexedBag without;
  a.for_each([&](KeyframeId id, EntryInfo info, const TopologyGraph<>& graph) {
    described += info.image.known() ? 1U : 0U;
    info.image = {};
    without.add(id, graph, info);
  });
  a.compact();
  without.compact();
  CHECK(a.memory_usage().entries >= without.memory_usage().entries + 24 * described);
}
