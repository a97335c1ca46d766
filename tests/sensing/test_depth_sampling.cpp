// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <topobag/sensing/depth_sampling.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

const BoundingBox box{100.0, 100.0, 200.0, 180.0};

/// A wall at 3 m with a thing at 1.2 m before it, of which `covers` says where it is.
template <typename Covers>
auto thing_before_wall(const Covers& covers) {
  return [covers](const Eigen::Vector2d& pixel) -> std::optional<double> {
    return covers(pixel) ? 1.2 : 3.0;
  };
}

}  // namespace

TEST_CASE("eq. 1: the paper takes the depth at the box centre", "[sensing][paper]") {
  const auto depth = [](const Eigen::Vector2d& pixel) -> std::optional<double> {
    if (pixel == Eigen::Vector2d(150.0, 140.0)) return 1.5;
    return 9.0;
  };
  CHECK(CenterDepth{}(depth, box) == 1.5);
  const auto hole = [](const Eigen::Vector2d&) -> std::optional<double> { return std::nullopt; };
  CHECK_FALSE(CenterDepth{}(hole, box));
}

TEST_CASE("robust depth of a flat thing is its depth", "[sensing]") {
  const auto flat = [](const Eigen::Vector2d&) -> std::optional<double> { return 2.0; };
  CHECK(RobustBoxDepth{}(flat, box) == 2.0);
  CHECK(RobustBoxDepth{}(flat, BoundingBox{5.0, 5.0, 5.2, 5.1}) == 2.0);  // less than a pixel
}

TEST_CASE("the samples lie evenly about the box's centre", "[sensing]") {
  std::vector<Eigen::Vector2d> pixels;
  const auto recorded = [&](const Eigen::Vector2d& pixel) -> std::optional<double> {
    pixels.push_back(pixel);
    return 2.0;
  };
  RobustBoxDepth{0.5, 2}(recorded, box);  // of the inner 50 × 40 px
  REQUIRE(pixels.size() == 4);
  CHECK(pixels[0].isApprox(Eigen::Vector2d(137.5, 130.0)));
  CHECK(pixels[1].isApprox(Eigen::Vector2d(162.5, 130.0)));
  CHECK(pixels[2].isApprox(Eigen::Vector2d(137.5, 150.0)));
  CHECK(pixels[3].isApprox(Eigen::Vector2d(162.5, 150.0)));
}

TEST_CASE("robust depth survives holes, as long as something was measured", "[sensing]") {
  for (const double share : {0.3, 0.6, 0.85}) {
    CAPTURE(share);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto holes = [&](const Eigen::Vector2d&) -> std::optional<double> {
      if (unit(random) < share) return std::nullopt;
      return 2.0 + 0.01 * (unit(random) - 0.5);
    };
    const auto depth = RobustBoxDepth{}(holes, box);
    REQUIRE(depth);
    CHECK(*depth == Approx(2.0).margin(0.005));
  }
  const auto nothing = [](const Eigen::Vector2d&) -> std::optional<double> { return std::nullopt; };
  CHECK_FALSE(RobustBoxDepth{}(nothing, box));
}

TEST_CASE("with too few measured samples there is no depth", "[sensing]") {
  int count = 0;
  const auto one_in_twenty = [&](const Eigen::Vector2d&) -> std::optional<double> {
    if (count++ % 20 != 0) return std::nullopt;
    return 2.0;
  };
  CHECK_FALSE(RobustBoxDepth{}(one_in_twenty, box));
  RobustBoxDepth lenient;
  lenient.min_valid_share = 0.04;
  CHECK(lenient(one_in_twenty, box) == 2.0);
}

TEST_CASE("the background behind a thin thing is not its depth", "[sensing]") {
  // A frame of bars, as of a chair's back: the centre looks through it.
  const auto bars = thing_before_wall(
      [](const Eigen::Vector2d& p) { return std::fmod(p.x() - 100.0, 10.0) < 4.5; });
  const auto thing = RobustBoxDepth{}(bars, box);
  REQUIRE(thing);
  CHECK(*thing == 1.2);
  // A slim post that covers 15 % of the sampled part is too little to tell from an edge.
  const auto post =
      thing_before_wall([](const Eigen::Vector2d& p) { return std::abs(p.x() - 150.0) < 4.5; });
  CHECK(RobustBoxDepth{}(post, box) == 3.0);
}

TEST_CASE("a few nearer pixels at the edge do not pull the depth", "[sensing]") {
  const auto edge =
      thing_before_wall([](const Eigen::Vector2d& p) { return p.y() < 125.0 && p.x() < 150.0; });
  CHECK(RobustBoxDepth{}(edge, box) == 3.0);
}

TEST_CASE("mixed pixels between a thing and its background count for neither", "[sensing]") {
  // 40 % thing, 20 % flying pixels between the two, 40 % wall.
  const auto mixed = [](const Eigen::Vector2d& p) -> std::optional<double> {
    const double along = (p.x() - 120.0) / 60.0;  // over the sampled part
    if (along < 0.4) return 1.2;
    if (along > 0.6) return 3.0;
    return 1.2 + (along - 0.4) / 0.2 * 1.8;
  };
  const auto depth = RobustBoxDepth{}(mixed, box);
  REQUIRE(depth);
  CHECK(*depth == Approx(1.2).margin(0.05));
}

TEST_CASE("robust depth of noise is near the median of what it saw", "[sensing]") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(2.0, 0.02);
    const auto noisy = [&](const Eigen::Vector2d&) -> std::optional<double> {
      return noise(random);
    };
    const auto depth = RobustBoxDepth{}(noisy, box);
    REQUIRE(depth);
    CHECK(*depth == Approx(2.0).margin(0.02));
  }
}

TEST_CASE("a depth source that says NaN for a hole does no harm", "[sensing][regression]") {
  int count = 0;
  const double holes[] = {std::numeric_limits<double>::quiet_NaN(), 0.0, -1.0,
                          std::numeric_limits<double>::infinity()};
  const auto source = [&](const Eigen::Vector2d&) -> std::optional<double> {
    ++count;
    if (count % 2 == 0) return 2.0;
    return holes[(count / 2) % 4];
  };
  CHECK(RobustBoxDepth{}(source, box) == 2.0);
  const auto nan_alone = [&](const Eigen::Vector2d&) -> std::optional<double> { return holes[0]; };
  CHECK_FALSE(RobustBoxDepth{}(nan_alone, box));
}

TEST_CASE("a box wider than an int is sampled as any other", "[sensing][regression]") {
  int samples = 0;
  const auto flat = [&](const Eigen::Vector2d&) -> std::optional<double> {
    ++samples;
    return 2.0;
  };
  CHECK(RobustBoxDepth{}(flat, BoundingBox{-1e12, -1e12, 1e12, 1e12}) == 2.0);
  CHECK(samples == 24 * 24);
}

TEST_CASE("a share above 1 asks for the largest cluster", "[sensing][regression]") {
  const auto flat = [](const Eigen::Vector2d& pixel) -> std::optional<double> {
    return pixel.x() < box.center().x() ? 2.0 : 4.0;
  };
  RobustBoxDepth percent;
  percent.min_cluster_share = 50.0;
  RobustBoxDepth whole;
  whole.min_cluster_share = 1.0;
  CHECK(percent(flat, box) == whole(flat, box));
}
