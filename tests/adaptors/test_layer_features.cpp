// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>
#include <vector>

#include <topobag/adaptors/layer_features.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

namespace {

struct FeatureMap {
  std::size_t channels, rows, columns;
  std::vector<float> numbers;

  LayerOutput output() const { return {numbers.data(), channels, rows, columns}; }
  float at(std::size_t c, std::size_t row, std::size_t column) const {
    return numbers[(c * rows + row) * columns + column];
  }
};

FeatureMap random_features(std::size_t channels, std::size_t rows, std::size_t columns,
                           unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-1.0F, 2.0F);
  FeatureMap map{channels, rows, columns, {}};
  for (std::size_t i = 0; i < channels * rows * columns; ++i) map.numbers.push_back(number(random));
  return map;
}

AppearanceKind kind_for(std::size_t channels) {
  return AppearanceKind("layer:test", LayerFeatures::length_for(channels));
}

/// The mean over a box whose borders are multiples of 1/8 of a cell, sample by sample.
double sampled_mean(const FeatureMap& map, std::size_t c, const BoundingBox& box, double cell) {
  double sum = 0.0, count = 0.0;
  for (double y = box.y1 + cell / 16; y < box.y2; y += cell / 8) {
    for (double x = box.x1 + cell / 16; x < box.x2; x += cell / 8) {
      sum += static_cast<double>(
          map.at(c, static_cast<std::size_t>(y / cell), static_cast<std::size_t>(x / cell)));
      count += 1.0;
    }
  }
  return sum / count;
}

}  // namespace

TEST_CASE("a box is described by the mean of its cells less the image's, by brute force",
          "[adaptors][appearance]") {
  const int side = 64;  // px; cells of 8
  std::mt19937 random(5);
  for (int round = 0; round < 100; ++round) {
    const FeatureMap map = random_features(7, 8, 8, static_cast<unsigned>(round));
    const LayerFeatures describe(map.output(), kind_for(7), side);
    const auto border = [&] { return static_cast<double>(random() % 56); };
    const double x = border(), y = border();
    const BoundingBox box{x, y, x + 1.0 + static_cast<double>(random() % 7),
                          y + 1.0 + static_cast<double>(random() % 7)};
    Eigen::VectorXd expected(7);
    for (std::size_t c = 0; c < 7; ++c) {
      expected[static_cast<Eigen::Index>(c)] =
          sampled_mean(map, c, box, 8.0) - sampled_mean(map, c, {0, 0, 64, 64}, 8.0);
    }
    const Appearance found = describe(box);
    REQUIRE(found.known());
    CHECK(cosine_similarity(found, Appearance(kind_for(7), expected)) > 0.9995);
  }
}

TEST_CASE("many channels are folded so that inner products keep their expectation",
          "[adaptors][appearance]") {
  const std::size_t channels = 960;
  CHECK(LayerFeatures::length_for(channels) == 64);
  double off = 0.0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const FeatureMap map = random_features(channels, 1, 3, seed);
    const LayerFeatures describe(map.output(), kind_for(channels), 3);
    Eigen::MatrixXd cells(static_cast<Eigen::Index>(channels), 3);
    for (std::size_t c = 0; c < channels; ++c) {
      for (std::size_t i = 0; i < 3; ++i) {
        cells(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(i)) =
            static_cast<double>(map.at(c, 0, i));
      }
    }
    cells.colwise() -= cells.rowwise().mean().eval();
    const double whole = cells.col(0).normalized().dot(cells.col(1).normalized());
    const double folded = cosine_similarity(describe({0, 0, 1, 3}), describe({1, 0, 2, 3}));
    CHECK(folded == Approx(whole).margin(0.5));
    off += (folded - whole) / 20.0;
  }
  CHECK(std::abs(off) < 0.1);
}

TEST_CASE("what no cell tells is unknown", "[adaptors][appearance]") {
  const FeatureMap map = random_features(4, 5, 5, 1);
  const LayerFeatures describe(map.output(), kind_for(4), 50);
  CHECK(describe({10, 10, 20, 20}).known());
  CHECK(describe({-10, -10, 20, 20}) == describe({0, 0, 20, 20}));
  CHECK_FALSE(describe({60, 10, 70, 20}).known());
  CHECK_FALSE(describe({20, 20, 20, 30}).known());
  CHECK_FALSE(describe({0, 0, 50, 50}).known());  // it is the whole image
  const FeatureMap flat{2, 2, 2, std::vector<float>(8, 3.0F)};
  CHECK_FALSE(LayerFeatures(flat.output(), kind_for(2), 50)({10, 10, 20, 20}).known());
  FeatureMap broken = random_features(1, 2, 2, 1);
  broken.numbers[0] = std::nanf("");
  CHECK_FALSE(LayerFeatures(broken.output(), kind_for(1), 2)({1, 1, 2, 2}).known());
}

TEST_CASE("an output that is no map of features is refused", "[adaptors][appearance]") {
  const FeatureMap map = random_features(4, 5, 5, 1);
  CHECK(error_text([&] { LayerFeatures({}, kind_for(1), 50); }) ==
        "the layer puts out no map of features");
  CHECK(error_text([&] { LayerFeatures(map.output(), kind_for(5), 50); }) ==
        "a kind of 5 numbers for a layer of 4 channels");
}
