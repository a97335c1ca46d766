// SPDX-License-Identifier: MIT
#include <array>
#include <optional>
#include <vector>

#include <topobag/sensing/color_descriptor.hpp>

#include "catch.hpp"
#include "sensing/painted_image.hpp"

using namespace topobag;

namespace {

constexpr std::array<int, 3> red{160, 40, 40}, blue{40, 50, 150}, white{180, 180, 180};

/// A red mug, one with a white lower half, and a blue one.
PaintedImage three_mugs(unsigned seed = 1) {
  PaintedImage image(seed);
  image.paint(20, 40, 60, 80, red);
  image.paint(80, 40, 120, 80, red);
  image.paint(80, 60, 120, 80, white);
  image.paint(140, 40, 180, 80, blue);
  return image;
}

const BoundingBox first_mug{20, 40, 59, 79}, second_mug{80, 40, 119, 79},
    third_mug{140, 40, 179, 79};

}  // namespace

TEST_CASE("a descriptor is of the one kind", "[sensing][appearance]") {
  const PaintedImage image = three_mugs();
  const ColorDescriptor describe(image.view());
  CHECK(describe(first_mug).kind() == ColorDescriptor::kind);
  CHECK(ColorDescriptor::kind.length() == 54);
  CHECK(ColorDescriptor::kind == AppearanceKind(ColorDescriptor::name, 54));
}

TEST_CASE("colours tell objects apart, and halves of one", "[sensing][appearance]") {
  const PaintedImage image = three_mugs(1), again = three_mugs(2);
  const ColorDescriptor describe(image.view()), describe_again(again.view());
  const auto a = describe(first_mug), b = describe(second_mug), c = describe(third_mug);
  CHECK(cosine_similarity(a, describe_again(first_mug)) > 0.99);
  CHECK(cosine_similarity(b, describe_again(second_mug)) > 0.99);
  CHECK(cosine_similarity(a, b) < 0.9);
  CHECK(cosine_similarity(a, c) < cosine_similarity(a, b));
  PaintedImage upside_down(1);
  upside_down.paint(80, 40, 120, 60, white);
  upside_down.paint(80, 60, 120, 80, red);
  CHECK(cosine_similarity(b, ColorDescriptor(upside_down.view())(second_mug)) < 0.9);
}

TEST_CASE("exposure and white balance drop out where they clip nothing", "[sensing][appearance]") {
  const PaintedImage image = three_mugs();
  const ColorDescriptor describe(image.view());
  const std::vector<std::array<double, 3>> gains{
      {0.6, 0.6, 0.6}, {1.4, 1.4, 1.4}, {1.2, 1.0, 0.8}, {0.8, 1.0, 1.2}};
  for (const auto& gain : gains) {
    const PaintedImage shifted = image.under(gain);
    const ColorDescriptor describe_shifted(shifted.view());
    for (const BoundingBox& mug : {first_mug, second_mug, third_mug}) {
      CHECK(cosine_similarity(describe(mug), describe_shifted(mug)) > 0.98);
    }
    CHECK(cosine_similarity(describe(first_mug), describe_shifted(third_mug)) < 0.9);
  }
}

TEST_CASE("pixels before and behind the object do not count", "[sensing][appearance]") {
  const PaintedImage image = three_mugs();
  const ColorDescriptor describe(image.view());
  const BoundingBox both{20, 40, 119, 59};  // the red halves, and grey between them
  const BoundingBox wide{20, 40, 179, 79};
  const auto depth = [](const Eigen::Vector2d& pixel) -> std::optional<double> {
    return pixel.x() < 130 ? 1.0 : 1.3;
  };
  const auto all_far = [](const Eigen::Vector2d&) -> std::optional<double> { return 3.0; };
  const auto none = [](const Eigen::Vector2d&) -> std::optional<double> { return std::nullopt; };
  CHECK(describe(both, depth, 1.0) == describe(both));
  CHECK(describe(wide, depth, 1.0) != describe(wide));
  CHECK(describe(wide, depth, 1.0) != describe(wide, depth, 1.3));
  CHECK(cosine_similarity(describe(wide, depth, 1.3), describe(third_mug)) >
        cosine_similarity(describe(wide, depth, 1.0), describe(third_mug)));
  CHECK(describe(wide, none, 1.0) == describe(wide));
  CHECK(describe(wide, depth, 0.0) == describe(wide));
  CHECK_FALSE(describe(wide, all_far, 1.0).known());
}

TEST_CASE("a box of no size, or outside the image, looks like nothing", "[sensing][appearance]") {
  const PaintedImage image = three_mugs();
  const ColorDescriptor describe(image.view());
  CHECK_FALSE(describe(BoundingBox{}).known());
  CHECK_FALSE(describe({300, 10, 320, 30}).known());
  CHECK_FALSE(describe({-40, -40, -20, -20}).known());
  CHECK(describe({-40, -40, 20, 20}).known());
  CHECK(describe({150.2, 70.2, 150.4, 70.4}).known());
  CHECK(describe({-1e300, -1e300, 1e300, 1e300}).known() == false);
}

TEST_CASE("an image of one pixel has a colour", "[sensing][appearance]") {
  const std::array<std::uint8_t, 3> pixel{10, 20, 30};
  const ColorDescriptor describe(ImageView(pixel.data(), 1, 1, ColorOrder::rgb));
  CHECK(describe({-0.4, -0.4, 0.4, 0.4}).known());
}
