// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "leave_one_out.hpp"

using topobag::PoseVerdict;

TEST_CASE("a place that is left out has no say in what is asked of it", "[benchmarks]") {
  const RunQueries easy{{"desk"}, {{2.0, PoseVerdict::correct}, {-1.0, PoseVerdict::wrong}}};
  const RunQueries hard{{"rack"}, {{1.0, PoseVerdict::wrong}, {3.0, PoseVerdict::correct}}};
  const auto folds = leave_one_out({easy, hard}, 0.0);
  REQUIRE(folds.size() == 2);
  CHECK(folds[0].place == "desk");
  CHECK(folds[0].margin > 1.0);
  CHECK(folds[0].left_out.correct == 1);
  CHECK(folds[0].left_out.wrong == 0);
  CHECK(folds[1].place == "rack");
  CHECK((folds[1].margin > -1.0 && folds[1].margin < 1.0));
  CHECK(folds[1].left_out.wrong == 1);
}

TEST_CASE("every query is kept or left out, and few of the kept ones are answered falsely",
          "[benchmarks]") {
  std::mt19937 random(9);
  std::normal_distribution<double> margin;
  const std::vector<std::string> names{"a", "b", "c"};
  for (int round = 0; round < 50; ++round) {
    std::vector<RunQueries> runs(5);
    std::size_t queries = 0;
    for (RunQueries& run : runs) {
      run.places = {names[random() % 3], names[random() % 3]};
      run.queries.resize(random() % 60);
      queries += run.queries.size();
      for (ScoredQuery& query : run.queries) {
        query = {margin(random), random() % 3 == 0 ? PoseVerdict::wrong : PoseVerdict::correct};
      }
    }
    for (const LeftOut& fold : leave_one_out(runs, 0.05)) {
      CHECK(fold.kept.queries + fold.left_out.queries == queries);
      CHECK(20 * fold.kept.wrong <= fold.kept.queries);
    }
  }
}
