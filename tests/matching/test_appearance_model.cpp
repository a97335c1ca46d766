// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <random>

#include <topobag/matching/appearance_model.hpp>
#include <topobag/matching/match_graphs.hpp>

#include "catch.hpp"
#include "layouts.hpp"
#include "random_appearance.hpp"

using namespace topobag;

TEST_CASE("a table is read between its points, and held at its ends", "[matching][appearance]") {
  AppearanceModel model;
  model.table = {{0.0, -1.0}, {0.5, 0.0}, {1.0, 2.0}};
  CHECK(model.log10_odds(-0.3) == -1.0);
  CHECK(model.log10_odds(0.0) == -1.0);
  CHECK(model.log10_odds(0.1) == Approx(-0.8));
  CHECK(model.log10_odds(0.5) == Approx(0.0));
  CHECK(model.log10_odds(0.75) == Approx(1.0));
  CHECK(model.log10_odds(1.0) == 2.0);
  model.table = {{0.4, 0.3}};
  CHECK(model.log10_odds(0.1) == 0.3);
  CHECK(model.log10_odds(0.9) == 0.3);
}

TEST_CASE("pairs of one match say together what they say, up to what the shares allow",
          "[matching][appearance]") {
  const AppearanceModel model;
  CHECK(model.log10_odds_together(0.0) == Approx(0.0).margin(1e-12));
  double before = -10.0;
  for (double sum = -12.0; sum <= 12.0; sum += 0.25) {
    const double together = model.log10_odds_together(sum);
    CHECK(together > before - 1e-12);
    CHECK(std::abs(together) <= std::abs(sum) + 1e-12);
    before = together;
  }
  CHECK(std::abs(model.log10_odds_together(0.5) - 0.5) < 0.05);
  CHECK(model.log10_odds_together(1e6) ==
        Approx(std::log10((1.0 - model.light_changed) / model.furnished_alike)));
  CHECK(model.log10_odds_together(-1e6) ==
        Approx(std::log10(model.light_changed / (1.0 - model.furnished_alike))));
}

TEST_CASE("a table that does not rise is refused", "[matching][appearance]") {
  AppearanceModel model;
  model.validate();
  for (const AppearanceOdds& bad :
       {AppearanceOdds{0.70, 1.0}, AppearanceOdds{0.9, -2.0}, AppearanceOdds{std::nan(""), 0.0},
        AppearanceOdds{0.9, INFINITY}}) {
    model.table = {{0.7, -0.5}, bad};
    CHECK_THROWS_AS(model.validate(), InvalidValue);
  }
}

TEST_CASE("the default table rises", "[matching][appearance]") {
  const AppearanceModel model;
  for (std::size_t i = 1; i < model.table.size(); ++i) {
    CHECK(model.table[i].similarity > model.table[i - 1].similarity);
    CHECK(model.table[i].log10_odds > model.table[i - 1].log10_odds);
  }
  CHECK(model.log10_odds(0.5) < 0.0);
  CHECK(model.log10_odds(1.0) > 0.0);
}

TEST_CASE("what is unknown or of another kind says nothing", "[matching][appearance]") {
  std::mt19937 random(1);
  const Appearance color = random_appearance(random, ColorDescriptor::kind);
  const Appearance clip = random_appearance(random, AppearanceKind("clip", 32));
  AppearanceModel model;
  CHECK(model.log10_odds(color, color) == model.table.back().log10_odds);
  CHECK(model.log10_odds(color, {}) == 0.0);
  CHECK(model.log10_odds({}, color) == 0.0);
  CHECK(model.log10_odds({}, {}) == 0.0);
  CHECK(model.log10_odds(color, clip) == 0.0);
  CHECK(model.log10_odds(clip, clip) == 0.0);
  model.table.clear();
  CHECK(model.log10_odds(color, color) == 0.0);
  model.kind = {};
  model.table = {{0.0, 1.0}};
  CHECK(model.log10_odds({}, {}) == 0.0);
}

TEST_CASE("a match scores what its pairs look like, and nothing else changes",
          "[matching][appearance]") {
  std::mt19937 random(2);
  std::size_t compared = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const TopologyGraph<> plain = noisy_graph(random, 7, 3);
    const TopologyGraph<> again = jittered(random, plain, 0.5);
    const TopologyGraph<> candidate = with_appearance(random, plain, ColorDescriptor::kind);
    const TopologyGraph<> query = with_appearance(random, again, ColorDescriptor::kind);
    const MatchOptions options;
    const GraphMatch bare = match_graphs(plain, again, options);
    const GraphMatch described = match_graphs(candidate, query, options);
    for (const RelativePose& pose : described.poses) {
      for (const RelativePose& other : bare.poses) {
        if (other.inliers != pose.inliers) continue;
        double odds = 0.0;
        for (const Correspondence& pair : pose.inliers) {
          odds += options.chance.appearance.log10_odds(candidate.node(pair.candidate).appearance,
                                                       query.node(pair.query).appearance);
        }
        CHECK(pose.significance ==
              Approx(other.significance + options.chance.appearance.log10_odds_together(odds))
                  .margin(1e-9));
        ++compared;
      }
    }
  }
  CHECK(compared >= 40);
}
