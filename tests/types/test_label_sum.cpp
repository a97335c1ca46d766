// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

#include <topobag/types/label_sum.hpp>

#include "catch.hpp"
#include "random_label_weights.hpp"

using namespace topobag;

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
