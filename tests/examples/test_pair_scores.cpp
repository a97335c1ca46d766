// SPDX-License-Identifier: MIT
#include "pair_scores.hpp"

#include <tuple>
#include <vector>

#include "catch.hpp"
#include "scratch_folder.hpp"

namespace {

using Scored = std::vector<std::tuple<std::size_t, std::size_t, double>>;

Scored scored(const program::PairScores& scores) {
  Scored all;
  program::for_each_score(scores, [&](std::size_t query, std::size_t candidate, double score) {
    all.emplace_back(query, candidate, score);
  });
  return all;
}

}  // namespace

TEST_CASE("a matrix and a list of scores are visited alike, by query, then by candidate",
          "[examples]") {
  const ScratchFolder folder;
  const std::string matrix = folder.write("m.csv", "0.5,nan\n0.25,1\n");
  const std::string list =
      folder.write("l.csv", "query,candidate,score\n0,0,0.5\n1,0,0.25\n1,1,1\n");
  const Scored expected{{0, 0, 0.5}, {1, 0, 0.25}, {1, 1, 1.0}};
  for (const std::string& path : {matrix, list}) {
    CHECK(scored(program::read_pair_scores(path, false)) == expected);
    CHECK(std::get<2>(scored(program::read_pair_scores(path, true)).at(0)) == -0.5);
  }
}
