// SPDX-License-Identifier: MIT
#include <limits>
#include <random>
#include <vector>

#include "catch.hpp"
#include "pooled_figures.hpp"

using topobag::PoseVerdict;

namespace {

/// Look-ups with few different margins, so that many tie.
std::vector<ScoredLookUp> random_look_ups(std::mt19937& random, std::size_t count) {
  std::uniform_int_distribution<int> margin(-5, 5), truth(0, 2), answers(0, 3);
  std::vector<ScoredLookUp> look_ups(count);
  for (ScoredLookUp& look_up : look_ups) {
    look_up.truth = static_cast<PoseVerdict>(truth(random));
    if (answers(random) > 0) look_up.margin = 0.5 * margin(random);
  }
  return look_ups;
}

}  // namespace

TEST_CASE("figures of a threshold count the answers that reach it", "[benchmarks]") {
  const std::vector<ScoredLookUp> look_ups{{1.0, PoseVerdict::correct},
                                           {0.0, PoseVerdict::wrong},
                                           {0.5, PoseVerdict::imprecise},
                                           {-0.1, PoseVerdict::correct},
                                           {std::nullopt, PoseVerdict::wrong}};
  const Figures figures = figures_at(look_ups, PooledMargins::by_default);
  CHECK(figures.look_ups == 5);
  CHECK(figures.accepted == 3);
  CHECK(figures.correct == 1);
  CHECK(figures.imprecise == 1);
  CHECK(figures.wrong == 1);
  CHECK(figures_at({}, 0.0).look_ups == 0);
}

TEST_CASE("a pool's margins are the least that keep wrong answers to their number",
          "[benchmarks]") {
  std::mt19937 random(4);
  for (int round = 0; round < 300; ++round) {
    const auto look_ups = random_look_ups(random, random() % 40U);
    for (const std::size_t allowed : {std::size_t{0}, std::size_t{1}, std::size_t{4}}) {
      const double margin = margin_for(look_ups, allowed);
      CHECK(figures_at(look_ups, margin).wrong <= allowed);
      // Any answer that is refused would let too many in, were it accepted.
      for (const ScoredLookUp& look_up : look_ups) {
        if (!look_up.margin || *look_up.margin >= margin) continue;
        CHECK(figures_at(look_ups, *look_up.margin).wrong > allowed);
      }
    }
  }
}

TEST_CASE("one false in a thousand look-ups counts those without an answer", "[benchmarks]") {
  std::vector<ScoredLookUp> pool{
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
  const std::vector<ScoredLookUp> pool{{-1e5, PoseVerdict::correct}};
  CHECK(pooled_margins(pool).beyond_best_false == -std::numeric_limits<double>::infinity());
  CHECK(figures_at(pool, pooled_margins(pool).beyond_best_false).correct == 1);
}
