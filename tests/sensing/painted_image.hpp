// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <topobag/sensing/image_view.hpp>

/// An image of 200 × 150 px on grey of some texture, to paint boxes into.
class PaintedImage {
 public:
  static constexpr int width = 200, height = 150;

  explicit PaintedImage(unsigned seed) : bytes_(std::size_t{3} * width * height) {
    std::mt19937 random(seed);
    for (auto& byte : bytes_) byte = static_cast<std::uint8_t>(90 + random() % 40);
  }

  /// Paints the pixels from (left, upper) up to but without (right, lower).
  void paint(int left, int upper, int right, int lower, const std::array<int, 3>& rgb) {
    for (int row = upper; row < lower; ++row) {
      for (int column = left; column < right; ++column) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
          bytes_[3 * static_cast<std::size_t>(row * width + column) + channel] =
              static_cast<std::uint8_t>(rgb[channel]);
        }
      }
    }
  }

  /// The image with each channel times a gain.
  PaintedImage under(const std::array<double, 3>& gains) const {
    PaintedImage image(*this);
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      image.bytes_[i] =
          static_cast<std::uint8_t>(std::min(255L, std::lround(bytes_[i] * gains[i % 3])));
    }
    return image;
  }

  topobag::ImageView view() const {
    return topobag::ImageView(bytes_.data(), width, height, topobag::ColorOrder::rgb);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};
