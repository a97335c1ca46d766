// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <map>

#include <topobag/bag/search_result.hpp>

#include "bag/desk_pieces.hpp"
#include "bag/filled_bags.hpp"
#include "catch.hpp"

using namespace topobag;

TEST_CASE("most graphs are never touched", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(2), 2);
  const IndexedBag bag = bag_of(source, 300);
  std::size_t visited = 0;
  for (int i = 0; i < 20; ++i) {
    const auto place = source.place();
    const SearchResult result = bag.view()->search(source.keyframe(place));
    CHECK(result.exact);
    CHECK(result.missed_similarity == 0.0);
    CHECK(result.entries == 3000);
    CHECK(result.untouched() == 3000 - result.visited);
    visited += result.visited;
  }
  CHECK(visited < 20 * 3000 / 3);
}

TEST_CASE("a search on a budget bounds what it missed", "[bag][index]") {
  RecombinedGraphs source(desk_pieces(3), 3);
  const IndexedBag bag = bag_of(source, 60);
  const BruteForceBag oracle = brute_force_of(bag);
  for (int i = 0; i < 20; ++i) {
    const TopologyGraph<> query = source.keyframe(source.place());
    QueryOptions all;
    all.max_results = bag.size();
    std::map<KeyframeId, double> scores;
    for (const Candidate& candidate : oracle.query(query, all)) {
      scores.emplace(candidate.id, candidate.similarity);
    }
    for (const std::size_t budget : {0u, 1u, 20u, 100u, 300u, 600u}) {
      const SearchResult result = bag.view()->search(query, {}, budget);
      CHECK(result.visited <= budget);
      CHECK(result.candidates == bag.view()->search(query, {}, budget).candidates);
      for (const Candidate& candidate : result.candidates) {
        CHECK(candidate.similarity == scores.at(candidate.id));
      }
      for (const Candidate& best : oracle.query(query)) {
        const auto& found = result.candidates;
        if (std::find(found.begin(), found.end(), best) != found.end()) continue;
        CHECK_FALSE(result.exact);
        CHECK(best.similarity <= result.missed_similarity);
      }
      CHECK(result.missed_similarity <= 1.0);
      if (budget >= bag.size()) CHECK(result.exact);
    }
  }
}
