// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <topobag/sensing/depth_grid.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const auto wall_at_two_metres = [](const Eigen::Vector2d&) { return std::optional<double>(2.0); };

}  // namespace

TEST_CASE("a depth grid is a depth source over the whole image and nothing more", "[sensing]") {
  static_assert(is_depth_source_v<DepthGrid>);
  const DepthGrid grid(wall_at_two_metres, 640, 480);
  for (const Eigen::Vector2d& inside :
       {Eigen::Vector2d(-0.5, -0.5), Eigen::Vector2d(320, 240), Eigen::Vector2d(639.4, 479.4)}) {
    CHECK(grid(inside) == 2.0);
  }
  for (const Eigen::Vector2d& outside :
       {Eigen::Vector2d(-0.6, 5), Eigen::Vector2d(639.6, 5), Eigen::Vector2d(5, -0.6),
        Eigen::Vector2d(5, 479.6), Eigen::Vector2d(std::nan(""), 5)}) {
    CHECK_FALSE(grid(outside));
  }
}

TEST_CASE("with as many samples as pixels a cell holds their least depth", "[sensing]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> metres(0.5F, 5.0F);
  std::vector<float> image(16 * 12);
  for (float& pixel : image) pixel = random() % 3 == 0 ? 0.0F : metres(random);
  const DepthView<float> view(image.data(), 16, 12, 1.0);
  const DepthGrid grid(view, 16, 12, 4, 3);  // cells of 4 × 4 pixels
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      float least = std::numeric_limits<float>::infinity();
      int measured = 0;
      for (int v = 4 * row; v < 4 * row + 4; ++v) {
        for (int u = 4 * column; u < 4 * column + 4; ++u) {
          const float pixel = image[static_cast<std::size_t>(16 * v + u)];
          if (!(pixel > 0.0F)) continue;
          ++measured;
          least = std::min(least, pixel);
        }
      }
      const auto found = grid({4.0 * column + 1.7, 4.0 * row + 2.2});
      CHECK(found.has_value() == (measured >= 8));
      if (found) CHECK(*found == static_cast<double>(least));
    }
  }
}

TEST_CASE("a depth grid needs an image and a cell", "[sensing]") {
  CHECK_THROWS_AS(DepthGrid(wall_at_two_metres, 0, 480), InvalidValue);
  CHECK_THROWS_AS(DepthGrid(wall_at_two_metres, 640, 480, 0, 3), InvalidValue);
}

TEST_CASE("an infinite depth is a hole", "[sensing][regression]") {
  const auto endless = [](const Eigen::Vector2d&) -> std::optional<double> {
    return std::numeric_limits<double>::infinity();
  };
  CHECK_FALSE(DepthGrid(endless, 640, 480)({320.0, 240.0}));
}
