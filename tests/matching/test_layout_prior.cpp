// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <topobag/error.hpp>
#include <topobag/matching/layout_prior.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

/// Counts drawn for three classes.
LayoutPrior drawn_layouts(std::mt19937& random) {
  std::exponential_distribution<double> count(0.5);
  LayoutPrior prior;
  for (int a = 1; a <= 3; ++a) {
    for (int b = a; b <= 3; ++b) {
      DistanceCounts level{}, spatial{};
      for (double& n : level) n = count(random);
      for (double& n : spatial) n = count(random);
      prior.add(ClassId{b}, ClassId{a}, level, spatial);
    }
  }
  return prior;
}

struct Link {
  std::size_t a, b;
};

bool is_tree(const std::vector<Link>& links, std::size_t objects) {
  std::vector<std::size_t> part(objects);
  for (std::size_t i = 0; i < objects; ++i) part[i] = i;
  for (const Link& link : links) {
    const std::size_t from = part[link.b], to = part[link.a];
    if (from == to) return false;
    std::replace(part.begin(), part.end(), from, to);
  }
  return links.size() + 1 == objects;
}

/// The largest odds of all spanning trees, each tried.
double largest_odds_of_trees(const LayoutPrior& prior, const std::vector<ClassId>& labels,
                             const std::vector<Eigen::Vector3d>& positions, double area,
                             double extent) {
  std::vector<Link> all;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) all.push_back({i, j});
  }
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t chosen = 0; chosen < std::size_t{1} << all.size(); ++chosen) {
    std::vector<Link> links;
    double odds = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if ((chosen >> k & 1U) == 0) continue;
      links.push_back(all[k]);
      const auto [a, b] = all[k];
      const double usual =
          prior.density(labels[a], labels[b], (positions[a] - positions[b]).norm(), extent, true);
      odds += std::log10(prior.even + (1.0 - prior.even) * usual * area);
    }
    if (is_tree(links, labels.size())) best = std::max(best, odds);
  }
  return best;
}

}  // namespace

TEST_CASE("a density of distances sums up to 1 within its extent", "[matching]") {
  std::mt19937 random(3);
  const LayoutPrior prior = drawn_layouts(random);
  for (const bool level : {true, false}) {
    for (const int a : {1, 2, 3, 9}) {
      for (std::size_t last = 0; last < DistanceBins::count; ++last) {
        CAPTURE(level, a, last);
        const auto middle = [](std::size_t bin) {
          return std::sqrt(DistanceBins::border(bin) * DistanceBins::border(bin + 1));
        };
        double sum = 0.0;
        for (std::size_t bin = 0; bin <= last; ++bin) {
          sum += DistanceBins::area(bin) *
                 prior.density(ClassId{a}, ClassId{2}, middle(bin), middle(last), level);
        }
        CHECK(sum == Approx(1.0));
      }
    }
  }
}

TEST_CASE("the odds of a layout are the largest of all spanning trees", "[matching]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const LayoutPrior prior = drawn_layouts(random);
    std::vector<ClassId> labels;
    std::vector<Eigen::Vector3d> positions;
    for (std::size_t i = 0; i < 2 + static_cast<std::size_t>(round) % 4; ++i) {
      labels.push_back(ClassId{static_cast<int>(random() % 4)});
      positions.emplace_back(place(random), place(random), 0.0);
    }
    CHECK(prior.log10_odds(labels, positions, 3.0, 2.8, true) ==
          Approx(largest_odds_of_trees(prior, labels, positions, 3.0, 2.8)));
  }
}

TEST_CASE("a usual distance is likelier elsewhere, whatever the order of the two", "[matching]") {
  LayoutPrior prior;
  prior.even = 0.1;
  DistanceCounts beside{};
  beside[DistanceBins::of(0.25)] = 50.0;
  prior.add(ClassId{66}, ClassId{64}, beside, beside);
  const auto odds = [&](double distance, int a, int b) {
    return prior.log10_odds({ClassId{a}, ClassId{b}},
                            {Eigen::Vector3d::Zero(), {distance, 0.0, 0.0}}, 1.0, 1.5, false);
  };
  CHECK(odds(0.25, 64, 66) > 0.3);
  CHECK(odds(0.25, 64, 66) == odds(0.25, 66, 64));
  CHECK(odds(1.2, 64, 66) < -0.8);
  CHECK(odds(1.2, 64, 66) >= std::log10(prior.even));
  // Of classes never seen together, what holds for all pairs tells a little.
  CHECK(odds(0.25, 1, 2) < odds(0.25, 64, 66));
  CHECK(prior.log10_odds({ClassId{64}}, {Eigen::Vector3d::Zero()}, 1.0, 1.5, false) == 0.0);
}

TEST_CASE("distances beyond the bins are those of the last, counts below zero are refused",
          "[matching]") {
  CHECK(DistanceBins::of(0.0) == 0);
  CHECK(DistanceBins::of(1e9) == DistanceBins::count - 1);
  for (std::size_t bin = 0; bin < DistanceBins::count; ++bin) {
    CHECK(DistanceBins::of(1.001 * DistanceBins::border(bin)) == bin);
  }
  LayoutPrior prior;
  for (const double count : {-1.0, std::nan("")}) {
    DistanceCounts bad{};
    bad[3] = count;
    CHECK_THROWS_AS(prior.add(ClassId{1}, ClassId{2}, bad, {}), InvalidValue);
    CHECK_THROWS_AS(prior.add(ClassId{1}, ClassId{2}, {}, bad), InvalidValue);
  }
  CHECK(prior.empty());
}
