// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include <topobag/types/label_sum.hpp>
#include <topobag/types/label_weights.hpp>

#include "catch.hpp"
#include "random_label_weights.hpp"

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

TEST_CASE("what sightings say is added up by their confidence", "[types]") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0.1, 1.0);
  for (int trial = 0; trial < 100; ++trial) {
    LabelSum sum;
    std::map<ClassId, double> expected;
    for (std::size_t i = 1 + random() % 6; i > 0; --i) {
      const ClassId label{static_cast<int>(random() % 4)};
      const double confidence = unit(random);
      if (i % 2 == 0) {
        sum.add(label, {}, confidence);
        expected[label] += confidence;
        continue;
      }
      const LabelWeights weights = random_label_weights(random, label, 4);
      sum.add(label, weights, confidence);
      double total = 0.0;
      for (std::size_t k = 0; k < weights.size(); ++k) total += weights.byte(k);
      for (std::size_t k = 0; k < weights.size(); ++k) {
        expected[weights.label(k)] += confidence * weights.byte(k) / total;
      }
    }
    std::vector<WeightedLabel> all;
    double greatest = 0.0;
    for (const auto& [label, weight] : expected) {
      all.push_back({label, weight});
      greatest = std::max(greatest, weight);
    }
    CHECK(sum.weights() == LabelWeights(all));
    CHECK(expected.at(sum.label()) == Approx(greatest));
    CHECK(has_best_label(sum.label(), sum.weights()));
  }
  LabelSum sure;
  sure.add(ClassId{1}, {}, 0.5);
  sure.add(ClassId{2}, {}, 0.4);
  CHECK(sure.weights().empty());
  CHECK(sure.label() == ClassId{1});
}
