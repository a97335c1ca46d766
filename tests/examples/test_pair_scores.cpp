// SPDX-License-Identifier: MIT
#include "pair_scores.hpp"

#include <tuple>
#include <vector>

#include "catch.hpp"
#include "scratch.hpp"

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

TEST_CASE("what holds no scores is told by what it is", "[examples][regression]") {
  const ScratchFolder folder;
  const auto told = [&](const std::string& path) {
    return error_in(folder, [&] { program::read_pair_scores(path, false); });
  };
  CHECK(told(folder.write("x.bag", "\x89TBG\r\n\x1a\n")).find("x.bag: it is a saved map; scores") ==
        0);
  CHECK(told(folder.write("s.csv", "0;1\n1;0\n")) ==
        "s.csv:1: '0;1' is not a number: separate numbers by commas or blanks, not semicolons, and "
        "write 0.5, not 0,5.");
  CHECK(told(folder.path("none.csv")) ==
        "none.csv cannot be opened for reading: No such file or directory.");
}

TEST_CASE("pairs without a score are counted", "[examples][regression]") {
  topobag::LabelledScores labelled;
  labelled.scores.resize(3);
  CHECK(program::unscored_text(labelled, 3).empty());
  CHECK(program::unscored_text(labelled, 3600) ==
        ", without one for 3597 of the 3600 pairs that are true or false");
}
