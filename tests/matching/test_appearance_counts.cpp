// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <topobag/matching/appearance_counts.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

const AppearanceKind plane("plane", 2);

/// Two descriptors at about this cosine.
struct ApartBy {
  explicit ApartBy(double cosine)
      : a(plane, Eigen::Vector2d(1, 0)),
        b(plane, Eigen::Vector2d(cosine, std::sqrt(1.0 - cosine * cosine))) {}
  Appearance a, b;
};

double least_squares(const std::vector<double>& shares, const std::vector<double>& weights,
                     const std::vector<double>& fit) {
  double sum = 0.0;
  for (std::size_t i = 0; i < fit.size(); ++i) {
    sum += weights[i] * (shares[i] - fit[i]) * (shares[i] - fit[i]);
  }
  return sum;
}

/// The best rising fit by trying all rising sequences of the shares' pooled means.
std::vector<double> best_rising(const std::vector<double>& shares,
                                const std::vector<double>& weights) {
  const std::size_t n = shares.size();
  std::vector<double> best;
  for (std::size_t cuts = 0; cuts < std::size_t{1} << (n - 1); ++cuts) {
    std::vector<double> fit(n);
    for (std::size_t begin = 0; begin < n;) {
      std::size_t end = begin + 1;
      while (end < n && (cuts >> (end - 1) & 1) == 0) ++end;
      double sum = 0.0, weight = 0.0;
      for (std::size_t i = begin; i < end; ++i) {
        sum += weights[i] * shares[i];
        weight += weights[i];
      }
      std::fill(fit.begin() + static_cast<std::ptrdiff_t>(begin),
                fit.begin() + static_cast<std::ptrdiff_t>(end), sum / weight);
      begin = end;
    }
    if (!std::is_sorted(fit.begin(), fit.end())) continue;
    if (best.empty() ||
        least_squares(shares, weights, fit) < least_squares(shares, weights, best)) {
      best = fit;
    }
  }
  return best;
}

}  // namespace

TEST_CASE("a table of appearance is the best one that rises", "[matching][appearance]") {
  std::mt19937 random(1);
  const std::vector<double> cosines{-0.805, -0.2, 0.105, 0.395, 0.605, 0.805, 0.95};
  for (int trial = 0; trial < 50; ++trial) {
    AppearanceCounts counts(plane);
    std::vector<double> same, other;
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      const ApartBy pair(cosines[i]);
      same.push_back(static_cast<double>(random() % (20 * (i + 1))));
      other.push_back(1.0 + static_cast<double>(random() % (20 * (8 - i))));
      for (int k = 0; k < static_cast<int>(same.back()); ++k) counts.add_same(pair.a, pair.b);
      for (int k = 0; k < static_cast<int>(other.back()); ++k) counts.add_other(pair.a, pair.b);
    }
    AppearancePrior prior;
    prior.min_pairs = 1;
    const AppearanceModel model = counts.model(prior);
    model.validate();
    std::vector<double> shares, weights;
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      weights.push_back(same[i] + other[i]);
      shares.push_back(same[i] / weights[i]);
    }
    const std::vector<double> fit = best_rising(shares, weights);
    const auto total_same = static_cast<double>(counts.same());
    const auto total_other = static_cast<double>(counts.other());
    for (const AppearanceOdds& point : model.table) {
      // The fit of the bins that the point is the middle of.
      const auto near = std::min_element(cosines.begin(), cosines.end(), [&](double a, double b) {
        return std::abs(a - point.similarity) < std::abs(b - point.similarity);
      });
      const double share = fit[static_cast<std::size_t>(near - cosines.begin())];
      const double p = share / total_same, q = (1.0 - share) / total_other;
      const double odds = (0.9 * p + 0.1 * q) / (0.85 * q + 0.15 * p);
      CHECK(point.log10_odds == Approx(std::log10(odds)).margin(1e-9));
    }
    CHECK(model.table.front().log10_odds >= -1.0);
    CHECK(model.table.back().log10_odds <= std::log10(1.0 / 0.15) + 1e-12);
  }
}

TEST_CASE("looks that differ by nothing say nothing", "[matching][appearance]") {
  AppearanceCounts counts(plane);
  const ApartBy pair(0.5);
  for (int i = 0; i < 200; ++i) {
    counts.add_same(pair.a, pair.b);
    if (i % 2 == 0) counts.add_other(pair.a, pair.b);
  }
  const AppearanceModel model = counts.model();
  REQUIRE(model.table.size() == 1);
  CHECK(model.table[0].log10_odds == Approx(0.0).margin(1e-12));
  CHECK(model.kind == plane);
}

TEST_CASE("the extremes of similarity are counted", "[matching][appearance]") {
  AppearanceCounts counts(plane);
  for (int i = 0; i < 100; ++i) {
    counts.add_same(ApartBy(1.0).a, ApartBy(1.0).b);
    counts.add_other(ApartBy(-1.0).a, ApartBy(-1.0).b);
  }
  const AppearanceModel model = counts.model();
  REQUIRE(model.table.size() == 2);
  CHECK(model.table[0].log10_odds == Approx(std::log10(0.1 / 0.85)));
  CHECK(model.table[1].log10_odds == Approx(std::log10(0.9 / 0.15)));
}

TEST_CASE("what is unknown or of another kind is not counted, and few pairs teach nothing",
          "[matching][appearance]") {
  AppearanceCounts counts(plane);
  const ApartBy pair(0.5);
  counts.add_same({}, pair.a);
  counts.add_same(pair.a, {});
  counts.add_other({}, {});
  counts.add_other(pair.a, Appearance(AppearanceKind("line", 1), Appearance::Bytes{1}));
  CHECK(counts.same() == 0);
  CHECK(counts.other() == 0);
  for (int i = 0; i < 100; ++i) counts.add_same(pair.a, pair.b);
  CHECK(error_text([&] { counts.model(); }) ==
        "appearance is learnt from 100 pairs of one object and as many of two; there are 100 and "
        "0");
}

TEST_CASE("counts that were made apart add up to those made at once", "[matching]") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> cosine(-1.0, 1.0);
  AppearanceCounts one(plane), other(plane), all(plane);
  for (int i = 0; i < 400; ++i) {
    const ApartBy same(std::max(cosine(random), cosine(random))), two(cosine(random));
    AppearanceCounts& part = i % 3 == 0 ? one : other;
    for (AppearanceCounts* counts : {&part, &all}) {
      counts->add_same(same.a, same.b);
      counts->add_other(two.a, two.b);
    }
  }
  one += other;
  CHECK(one.kind() == plane);
  CHECK(one.same() == all.same());
  CHECK(one.other() == all.other());
  const auto sum = one.model().table, whole = all.model().table;
  REQUIRE(sum.size() == whole.size());
  for (std::size_t i = 0; i < sum.size(); ++i) {
    CHECK(sum[i].similarity == whole[i].similarity);
    CHECK(sum[i].log10_odds == whole[i].log10_odds);
  }
  const AppearanceCounts foreign(AppearanceKind("other", 2));
  CHECK(error_text([&] { one += foreign; }) == "counts of two kinds of descriptors do not add up");
  CHECK(one.same() == all.same());
}
