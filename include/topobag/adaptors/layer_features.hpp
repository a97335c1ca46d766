// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/types/appearance.hpp>
#include <topobag/types/bounding_box.hpp>

namespace topobag {
inline namespace v0 {

/// What a layer of a network puts out for one image: channels, each a map of rows × columns cells
/// that cover the network's input.
struct LayerOutput {
  const float* data = nullptr;  ///< channel by channel, row by row; not owned
  std::size_t channels = 0;     ///< numbers a cell
  std::size_t rows = 0;         ///< of cells
  std::size_t columns = 0;      ///< of cells
};

/// Describes the objects of one image by a network layer's features in their boxes.
///
/// A box's vector is the mean of the cells that it covers, each by the area covered, less the mean
/// of the whole map: what all of the image has in common tells no object from another. Of more than
/// 64 channels, channel c adds to number c mod 64, with the sign of a fixed hash of c: inner
/// products keep their expectation (count sketch: Charikar, Chen, Farach-Colton 2002).
class LayerFeatures {
 public:
  /// Numbers in a descriptor of a layer with so many channels.
  static constexpr std::size_t length_for(std::size_t channels) noexcept {
    return channels < AppearanceKind::max_length ? channels : AppearanceKind::max_length;
  }

  /// @param output      has to outlive this
  /// @param kind        of the descriptors, `length_for(channels)` long: the layer of one network
  /// @param input_size  side of the network's square input, px
  /// Throws InvalidValue for an output without a number, and for a kind of another length.
  /// O(channels · cells).
  LayerFeatures(const LayerOutput& output, AppearanceKind kind, int input_size)
      : output_(output), kind_(kind), input_size_(input_size) {
    if (output.data == nullptr || output.channels * output.rows * output.columns == 0 ||
        input_size < 1) {
      throw InvalidValue("the layer puts out no map of features");
    }
    if (kind.length() != length_for(output.channels)) {
      throw InvalidValue("a kind of " + std::to_string(kind.length()) + " numbers for a layer of " +
                         std::to_string(output.channels) + " channels");
    }
    const double side = input_size;
    mean_ = mean_over({0.0, 0.0, side, side});
  }

  /// What the box's object looks like; unknown where the box covers nothing of the input, or its
  /// features are the whole map's, or not finite.
  /// @param box  in px of the network's input, from its upper-left corner
  /// O(channels · cells of the box).
  Appearance operator()(const BoundingBox& box) const {
    const double side = input_size_;
    const BoundingBox inside{std::clamp(box.x1, 0.0, side), std::clamp(box.y1, 0.0, side),
                             std::clamp(box.x2, 0.0, side), std::clamp(box.y2, 0.0, side)};
    if (!(inside.x2 > inside.x1 && inside.y2 > inside.y1)) return {};
    const Eigen::VectorXd features = mean_over(inside) - mean_;
    if (!features.allFinite()) return {};
    // As much as rounding leaves of features that are the map's own.
    if (!(features.lpNorm<Eigen::Infinity>() > 1e-6 * mean_.lpNorm<Eigen::Infinity>())) return {};
    return Appearance(kind_, features);
  }

 private:
  /// −1 or 1, evenly, by the lowest bit of a mix of the channel's number.
  static double sign_of(std::size_t channel) noexcept {
    auto x = static_cast<std::uint32_t>(channel) * 0x9e3779b9U;
    x ^= x >> 16;
    x *= 0x85ebca6bU;
    x ^= x >> 13;
    return (x & 1U) != 0 ? 1.0 : -1.0;
  }

  /// How much of the cells from `low` to `high`, in cells, lies in cell `i`.
  static double covered(double low, double high, std::size_t i) noexcept {
    const auto at = static_cast<double>(i);
    return std::max(0.0, std::min(high, at + 1.0) - std::max(low, at));
  }

  /// The folded mean of the features in a box that lies in the input and has an area.
  Eigen::VectorXd mean_over(const BoundingBox& box) const {
    const double wide = static_cast<double>(output_.columns) / input_size_;
    const double high = static_cast<double>(output_.rows) / input_size_;
    const double x1 = box.x1 * wide, x2 = box.x2 * wide, y1 = box.y1 * high, y2 = box.y2 * high;
    const auto last = [](double end, std::size_t count) {
      return std::min(count, static_cast<std::size_t>(std::ceil(end)));
    };
    const bool folds = output_.channels > AppearanceKind::max_length;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(kind_.length()));
    for (std::size_t c = 0; c < output_.channels; ++c) {
      const float* const map = output_.data + c * output_.rows * output_.columns;
      double of_channel = 0.0;
      for (auto row = static_cast<std::size_t>(y1); row < last(y2, output_.rows); ++row) {
        double of_row = 0.0;
        for (auto column = static_cast<std::size_t>(x1); column < last(x2, output_.columns);
             ++column) {
          of_row +=
              covered(x1, x2, column) * static_cast<double>(map[row * output_.columns + column]);
        }
        of_channel += covered(y1, y2, row) * of_row;
      }
      sum[static_cast<Eigen::Index>(c % kind_.length())] +=
          folds ? sign_of(c) * of_channel : of_channel;
    }
    return sum / ((x2 - x1) * (y2 - y1));
  }

  LayerOutput output_;
  AppearanceKind kind_;
  int input_size_;
  Eigen::VectorXd mean_;
};

}  // namespace v0
}  // namespace topobag
