// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <topobag/sensing/depth_grid.hpp>
#include <topobag/sensing/depth_view.hpp>
#include <topobag/sensing/lift_detections.hpp>
#include <topobag/sensing/range_detections.hpp>

#include "catch.hpp"

using namespace topobag;

namespace {

using Image16 = Eigen::Matrix<std::uint16_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ImageFloat = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// width × height pixels with value 1000 + 100 row + column.
template <typename Pixel>
std::vector<Pixel> numbered(int width, int height) {
  std::vector<Pixel> pixels;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      pixels.push_back(static_cast<Pixel>(1000 + 100 * row + column));
    }
  }
  return pixels;
}

}  // namespace

static_assert(is_depth_source_v<DepthView<std::uint16_t>> && is_depth_source_v<DepthView<float>>);
static_assert(!is_depth_source_v<double>);

TEMPLATE_TEST_CASE("a depth view reads every pixel where it lies", "[sensing]", std::uint16_t,
                   float, double) {
  const auto pixels = numbered<TestType>(4, 3);
  const DepthView<TestType> view(pixels.data(), 4, 3, 1000.0);
  CHECK(view.width() == 4);
  CHECK(view.height() == 3);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const auto depth = view({column, row});
      REQUIRE(depth);
      CHECK(*depth == Approx(1.0 + 0.1 * row + 0.001 * column));
    }
  }
}

TEST_CASE("eq. 5: depth is the raw value over the scale F", "[sensing][paper]") {
  const std::uint16_t raw = 10000;
  CHECK(*DepthView<std::uint16_t>(&raw, 1, 1, 5000.0)({0, 0}) == Approx(2.0));
  CHECK(*DepthView<std::uint16_t>(&raw, 1, 1, 1000.0)({0, 0}) == Approx(10.0));
  const std::uint16_t largest = 65535;
  CHECK(*DepthView<std::uint16_t>(&largest, 1, 1, 5000.0)({0, 0}) == Approx(13.107));
}

TEST_CASE("depth between pixels is the nearest pixel's", "[sensing]") {
  const auto pixels = numbered<float>(3, 2);
  const DepthView<float> view(pixels.data(), 3, 2, 1.0);
  CHECK(view({0.49, 0.0}) == 1000.0);
  CHECK(view({0.5, 0.0}) == 1001.0);
  CHECK(view({1.2, 0.7}) == 1101.0);
}

TEST_CASE("there is no depth outside the image", "[sensing]") {
  const auto pixels = numbered<float>(3, 2);
  const DepthView<float> view(pixels.data(), 3, 2, 1.0);
  CHECK(view({-0.5, -0.5}) == 1000.0);
  CHECK(view({2.49, 1.49}) == 1102.0);
  CHECK_FALSE(view({-0.51, 0.0}));
  CHECK_FALSE(view({2.5, 0.0}));
  CHECK_FALSE(view({0.0, -0.51}));
  CHECK_FALSE(view({0.0, 1.5}));
  CHECK_FALSE(view({1e300, 0.0}));
  CHECK_FALSE(view({std::numeric_limits<double>::quiet_NaN(), 0.0}));
  CHECK_FALSE(view({0.0, -std::numeric_limits<double>::infinity()}));
}

TEST_CASE("zero, negative and non-finite depths are holes", "[sensing]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const float pixels[] = {0.0F, -1.0F, nan, inf, 1.0F};
  const DepthView<float> view(pixels, 5, 1, 1.0);
  for (int column = 0; column < 4; ++column) CHECK_FALSE(view({column, 0}));
  CHECK(view({4, 0}) == 1.0);
}

TEST_CASE("a row stride skips padding", "[sensing]") {
  const auto pixels = numbered<std::uint16_t>(5, 3);  // of which the last two columns are padding
  const DepthView<std::uint16_t> view(pixels.data(), 3, 3, 1.0, 5);
  CHECK(view({2, 2}) == 1202.0);
  CHECK_FALSE(view({3, 0}));
}

TEST_CASE("Eigen images and maps are viewed in place", "[sensing]") {
  auto pixels = numbered<std::uint16_t>(4, 3);
  const Image16 image = Eigen::Map<Image16>(pixels.data(), 3, 4);
  CHECK(depth_view(image, 1.0)({3, 1}) == 1103.0);

  const Eigen::Map<const Image16> map(pixels.data(), 3, 4);
  const auto view = depth_view(map, 1.0);
  CHECK(view.width() == 4);
  CHECK(view.height() == 3);
  CHECK(view({3, 1}) == 1103.0);
  pixels[7] = 42;
  CHECK(view({3, 1}) == 42.0);

  const Eigen::Map<const Image16, 0, Eigen::OuterStride<>> padded(pixels.data(), 3, 2,
                                                                  Eigen::OuterStride<>(4));
  CHECK(depth_view(padded, 1.0)({1, 2}) == 1201.0);
  CHECK_FALSE(depth_view(padded, 1.0)({2, 0}));
}

TEST_CASE("a map whose pixels have gaps is refused, not misread", "[sensing][regression]") {
  const auto pixels = numbered<float>(4, 2);
  using Stride = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::Map<const ImageFloat, 0, Stride> gapped(pixels.data(), 2, 2, Stride(4, 2));
  CHECK_THROWS_AS(depth_view(gapped, 1.0), InvalidValue);
}

TEST_CASE("a depth image that cannot be is refused", "[sensing]") {
  const float pixel = 1.0F;
  using View = DepthView<float>;
  CHECK_THROWS_AS(View(nullptr, 1, 1, 1.0), InvalidValue);
  CHECK_THROWS_AS(View(&pixel, 0, 1, 1.0), InvalidValue);
  CHECK_THROWS_AS(View(&pixel, 1, -1, 1.0), InvalidValue);
  CHECK_THROWS_AS(View(&pixel, 2, 1, 1.0, 1), InvalidValue);
  CHECK_THROWS_AS(View(&pixel, 1, 1, 0.0), InvalidValue);
  CHECK_THROWS_AS(View(&pixel, 1, 1, -5000.0), InvalidValue);
  CHECK_THROWS_AS(View(&pixel, 1, 1, std::numeric_limits<double>::quiet_NaN()), InvalidValue);
  CHECK_THROWS_AS(View(&pixel, 1, 1, std::numeric_limits<double>::infinity()), InvalidValue);
  const ImageFloat empty;
  CHECK_THROWS_AS(depth_view(empty, 1.0), InvalidValue);
}

TEST_CASE("a pixel just inside the border is the last one", "[sensing][regression]") {
  const float pixels[] = {1.0F, 99.0F};  // the second is not of the image
  const DepthView<float> view(pixels, 1, 1, 1.0);
  const double inside = std::nextafter(0.5, 0.0);
  CHECK(view({inside, 0.0}) == 1.0);
  CHECK(view({0.0, inside}) == 1.0);
}

TEST_CASE("depth of another image than the camera's is refused wherever it is asked for",
          "[sensing][regression]") {
  const std::vector<float> half(32 * 24, 2.0F);
  const DepthView<float> depth(half.data(), 32, 24, 1.0);
  const PinholeCamera<> twice{50, 50, 32, 24, 64, 48}, same{50, 50, 16, 12, 32, 24},
      unknown{50, 50, 16, 12};
  const std::vector<Detection> boxes{{box_around({10, 10}, 8, 8), ClassId{62}, 0.9}};
  const ClassCatalog catalog = ClassCatalog::coco80();
  CHECK_THROWS_AS(lift_detections(boxes, depth, twice, catalog), InvalidValue);
  CHECK_THROWS_AS(range_detections(boxes, depth, twice), InvalidValue);
  CHECK_THROWS_AS(DepthGrid(depth, 64, 48), InvalidValue);
  for (const PinholeCamera<>& fits : {same, unknown}) {
    CHECK(lift_detections(boxes, depth, fits, catalog).nodes.size() == 1);
    CHECK(range_detections(boxes, depth, fits).at(0).z == 2.0);
  }
  const auto of_no_size = [](const Eigen::Vector2d&) { return std::optional<double>(2.0); };
  CHECK_NOTHROW(lift_detections(boxes, of_no_size, twice, catalog));
}
