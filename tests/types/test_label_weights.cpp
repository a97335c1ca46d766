// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include <topobag/types/label_weights.hpp>

#include "catch.hpp"

using namespace topobag;

TEST_CASE("the best five labels are kept, within 1/510 of the best one's weight", "[types]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<WeightedLabel> labels(random() % 12);
    std::map<ClassId, double> sums;
    for (WeightedLabel& label : labels) {
      label = {ClassId{static_cast<int>(random() % 9)}, 1e3 * unit(random)};
      sums[label.label] += label.weight;
    }
    const LabelWeights weights(labels);
    if (sums.size() < 2) {
      CHECK(weights.empty());
      continue;
    }
    std::vector<double> ranked;
    for (const auto& [label, weight] : sums) ranked.push_back(weight);
    std::sort(ranked.rbegin(), ranked.rend());
    CHECK(weights.size() <= std::min<std::size_t>(5, sums.size()));
    for (std::size_t i = 0; i < weights.size(); ++i) {
      CHECK(std::abs(weights.byte(i) / 255.0 - sums.at(weights.label(i)) / ranked[0]) <=
            1.0001 / 510.0);
      CHECK(sums.at(weights.label(i)) == Approx(ranked[i]).margin(ranked[0] / 255.0));
      if (i > 0) CHECK(weights.byte(i - 1) >= weights.byte(i));
    }
    std::shuffle(labels.begin(), labels.end(), random);
    std::vector<WeightedLabel> kept;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      kept.push_back({weights.label(i), static_cast<double>(weights.byte(i))});
    }
    CHECK(LabelWeights(kept) == weights);
    CHECK(has_best_label(weights.label(0), weights));
    CHECK_FALSE(has_best_label(ClassId{99}, weights));
    for (std::size_t i = 0; i < weights.size(); ++i) {
      CHECK(has_best_label(weights.label(i), weights) == (weights.byte(i) == 255));
    }
  }
}

TEST_CASE("a sure detector has no label weights, and weights that are none are refused",
          "[types]") {
  CHECK(LabelWeights().empty());
  CHECK(LabelWeights({{ClassId{3}, 0.7}}).empty());
  CHECK(LabelWeights({{ClassId{3}, 0.7}, {ClassId{4}, 0.0}}).empty());
  CHECK(LabelWeights({{ClassId{3}, 1.0}, {ClassId{4}, 0.001}}).empty());
  CHECK(LabelWeights({{ClassId{3}, 0.0}, {ClassId{4}, 0.0}}).empty());
  CHECK(has_best_label(ClassId{5}, LabelWeights()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(LabelWeights({{ClassId{3}, -0.1}}), InvalidValue);
  CHECK_THROWS_AS(LabelWeights({{ClassId{3}, nan}}), InvalidValue);
}
