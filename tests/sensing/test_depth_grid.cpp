// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
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

TEST_CASE("with as many samples as pixels a cell holds their least depth, rounded down",
          "[sensing]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> metres(0.5F, 50.0F);
  constexpr int side = 8, width = DepthGrid::columns * side, height = DepthGrid::rows * side;
  std::vector<float> image(static_cast<std::size_t>(width * height));
  for (std::size_t i = 0; i < image.size(); ++i) {
    image[i] = random() % (i % width < width / 2 ? 4U : 2U) == 0 ? 0.0F : metres(random);
  }
  const DepthGrid grid(DepthView<float>(image.data(), width, height, 1.0), width, height);
  std::size_t holes = 0;
  for (int row = 0; row < DepthGrid::rows; ++row) {
    for (int column = 0; column < DepthGrid::columns; ++column) {
      float least = std::numeric_limits<float>::infinity();
      int measured = 0;
      for (int v = side * row; v < side * row + side; ++v) {
        for (int u = side * column; u < side * column + side; ++u) {
          const float pixel = image[static_cast<std::size_t>(width * v + u)];
          if (!(pixel > 0.0F)) continue;
          ++measured;
          least = std::min(least, pixel);
        }
      }
      const auto found = grid({side * column + 3.7, side * row + 5.2});
      CHECK(found.has_value() == (2 * measured >= side * side));
      holes += found ? 0U : 1U;
      if (!found) continue;
      CHECK(*found <= static_cast<double>(least));
      CHECK(*found * std::exp2(1.0 / DepthGrid::levels_per_octave) > static_cast<double>(least));
    }
  }
  CHECK(holes > 0);
}

TEST_CASE("what is too near is not measured, what is too far is as far as can be told",
          "[sensing]") {
  for (const auto& [metres, kept] : {std::pair{0.249, 0.0}, {0.25, 0.25}, {1e9, 53.8174}}) {
    const auto wall = [metres = metres](const Eigen::Vector2d&) {
      return std::optional<double>(metres);
    };
    CHECK(DepthGrid(wall, 640, 480)({320.0, 240.0}).value_or(0.0) == Approx(kept).epsilon(1e-5));
  }
}

TEST_CASE("a depth grid is its levels", "[sensing]") {
  const DepthGrid grid(wall_at_two_metres, 640, 480);
  const DepthGrid again(grid.levels(), grid.width(), grid.height());
  CHECK(again({100.0, 100.0}) == 2.0);
  CHECK(again.levels() == grid.levels());
}

TEST_CASE("a depth grid in another unit shows the same depths, never more", "[sensing]") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> octaves(-3.0, 3.0);
  DepthGrid::Levels levels{};
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = static_cast<DepthGrid::Level>(i % 64);
  const DepthGrid grid(levels, 640, 480);
  CHECK(grid.scaled(1.0).levels() == levels);
  for (int round = 0; round < 50; ++round) {
    const double factor = std::exp2(octaves(random));
    const DepthGrid other = grid.scaled(factor);
    for (int row = 0; row < DepthGrid::rows; ++row) {
      for (int column = 0; column < DepthGrid::columns; ++column) {
        const Eigen::Vector2d pixel(64.0 * column + 32.0, 60.0 * row + 30.0);
        const auto own = grid(pixel), scaled = other(pixel);
        // One level is lost by rounding down.
        const double step = std::exp2(1.0 / DepthGrid::levels_per_octave);
        if (!own || *own * factor < DepthGrid::least_metres) {
          CHECK_FALSE(scaled);
        } else if (*own * factor > step * DepthGrid::least_metres) {
          REQUIRE(scaled);
          CHECK(*scaled <= *own * factor * (1.0 + 1e-12));
          CHECK((*scaled * step > *own * factor * (1.0 - 1e-12) || *scaled > 53.0));
        }
      }
    }
  }
  for (const double factor : {0.0, -2.0, std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(grid.scaled(factor), InvalidValue);
  }
}

TEST_CASE("a depth grid needs an image", "[sensing]") {
  CHECK_THROWS_AS(DepthGrid(wall_at_two_metres, 0, 480), InvalidValue);
  CHECK_THROWS_AS(DepthGrid(DepthGrid::Levels{}, 640, 0), InvalidValue);
}

TEST_CASE("an infinite depth is a hole", "[sensing][regression]") {
  const auto endless = [](const Eigen::Vector2d&) -> std::optional<double> {
    return std::numeric_limits<double>::infinity();
  };
  CHECK_FALSE(DepthGrid(endless, 640, 480)({320.0, 240.0}));
}
