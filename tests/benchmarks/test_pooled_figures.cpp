// SPDX-License-Identifier: MIT
#include <limits>
#include <random>
#include <vector>

#include "catch.hpp"
#include "pooled_figures.hpp"

using topobag::PoseVerdict;

namespace {

/// Queries with few different margins, so that many tie.
std::vector<ScoredQuery> random_queries(std::mt19937& random, std::size_t count) {
  std::uniform_int_distribution<int> margin(-5, 5), truth(0, 2), answers(0, 3);
  std::vector<ScoredQuery> queries(count);
  for (ScoredQuery& query : queries) {
    query.truth = static_cast<PoseVerdict>(truth(random));
    if (answers(random) > 0) query.margin = 0.5 * margin(random);
  }
  return queries;
}

}  // namespace

TEST_CASE("figures of a threshold count the answers that reach it", "[benchmarks]") {
  const std::vector<ScoredQuery> queries{{1.0, PoseVerdict::correct},
                                         {0.0, PoseVerdict::wrong},
                                         {0.5, PoseVerdict::imprecise},
                                         {-0.1, PoseVerdict::correct},
                                         {std::nullopt, PoseVerdict::wrong}};
  const Figures figures = figures_at(queries, PooledMargins::by_default);
  CHECK(figures.queries == 5);
  CHECK(figures.accepted == 3);
  CHECK(figures.correct == 1);
  CHECK(figures.imprecise == 1);
  CHECK(figures.wrong == 1);
  CHECK(figures_at({}, 0.0).queries == 0);
}

TEST_CASE("a pool's margins are the least that keep wrong answers to their number",
          "[benchmarks]") {
  std::mt19937 random(4);
  for (int round = 0; round < 300; ++round) {
    const auto queries = random_queries(random, random() % 40U);
    for (const std::size_t allowed : {std::size_t{0}, std::size_t{1}, std::size_t{4}}) {
      const double margin = margin_for(queries, allowed);
      CHECK(figures_at(queries, margin).wrong <= allowed);
      // Any answer that is refused would let too many in, were it accepted.
      for (const ScoredQuery& query : queries) {
        if (!query.margin || *query.margin >= margin) continue;
        CHECK(figures_at(queries, *query.margin).wrong > allowed);
      }
    }
  }
}

TEST_CASE("one false in a thousand queries counts those without an answer", "[benchmarks]") {
  std::vector<ScoredQuery> pool{
      {3.0, PoseVerdict::wrong}, {2.0, PoseVerdict::wrong}, {2.5, PoseVerdict::correct}};
  pool.resize(999);
  CHECK(figures_at(pool, pooled_margins(pool).one_false_in_1000).wrong == 0);
  CHECK(figures_at(pool, pooled_margins(pool).one_false_in_1000).correct == 0);
  pool.resize(1000);
  CHECK(figures_at(pool, pooled_margins(pool).one_false_in_1000).wrong == 1);
  CHECK(figures_at(pool, pooled_margins(pool).one_false_in_1000).correct == 1);
  CHECK(figures_at(pool, pooled_margins(pool).beyond_best_false).accepted == 0);
}

TEST_CASE("without a wrong answer every answer is accepted", "[benchmarks]") {
  const std::vector<ScoredQuery> pool{{-1e5, PoseVerdict::correct}};
  CHECK(pooled_margins(pool).beyond_best_false == -std::numeric_limits<double>::infinity());
  CHECK(figures_at(pool, pooled_margins(pool).beyond_best_false).correct == 1);
}
