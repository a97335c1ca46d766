// SPDX-License-Identifier: MIT
#include <cstdint>
#include <vector>

#include <topobag/sensing/image_view.hpp>

#include "catch.hpp"
#include "error_text.hpp"

using namespace topobag;

TEST_CASE("an image is read in place, in its order and with its gaps", "[sensing]") {
  for (const int channels : {3, 4}) {
    for (const int gap : {0, 5}) {
      const int width = 3, height = 2, stride = width * channels + gap;
      std::vector<std::uint8_t> bytes(static_cast<std::size_t>(stride * height), 255);
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
          for (int channel = 0; channel < 3; ++channel) {
            bytes[static_cast<std::size_t>(row * stride + column * channels + channel)] =
                static_cast<std::uint8_t>(100 * channel + 10 * row + column);
          }
        }
      }
      const ImageView rgb(bytes.data(), width, height, ColorOrder::rgb, stride, channels);
      const ImageView bgr(bytes.data(), width, height, ColorOrder::bgr, gap == 0 ? 0 : stride,
                          channels);
      CHECK(rgb.width() == width);
      CHECK(rgb.height() == height);
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
          const auto at = static_cast<std::uint8_t>(10 * row + column);
          const auto middle = static_cast<std::uint8_t>(100 + at);
          const auto last = static_cast<std::uint8_t>(200 + at);
          CHECK(rgb(column, row) == ImageView::Color{at, middle, last});
          CHECK(bgr(column, row) == ImageView::Color{last, middle, at});
        }
      }
    }
  }
}

TEST_CASE("what is no colour image is refused", "[sensing]") {
  const std::vector<std::uint8_t> bytes(12);
  const auto said = [](const std::uint8_t* data, int width, int height, int stride, int channels) {
    return error_text([&] { ImageView(data, width, height, ColorOrder::rgb, stride, channels); });
  };
  CHECK(said(bytes.data(), 2, 2, 0, 3) == "nothing was thrown");
  CHECK(said(nullptr, 2, 2, 0, 3) == "the image is empty");
  CHECK(said(bytes.data(), 0, 2, 0, 3) == "the image is empty");
  CHECK(said(bytes.data(), 2, 0, 0, 3) == "the image is empty");
  CHECK(said(bytes.data(), 2, 2, 0, 1) == "a colour image has three channels at least");
  CHECK(said(bytes.data(), 2, 2, 5, 3) == "the image's row stride is below its row's bytes");
}
