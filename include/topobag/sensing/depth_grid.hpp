// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/sensing/depth_view.hpp>

namespace topobag {
inline namespace v0 {

/// A coarse copy of a depth image that keeps, for each cell, how far one can see at least: what a
/// key frame's free space costs to remember (4.8 kB by default).
class DepthGrid {
 public:
  /// @param depth         the depth source of an image
  /// @param width,height  of the image, px
  /// @param columns,rows  of the grid
  /// Each cell takes the least of 4 × 4 depths spread over it, and none when fewer than half of
  /// them are measured. Throws InvalidValue for a size below 1, and as
  /// `require_registered`. O(16 · columns · rows).
  template <typename DepthSource>
  DepthGrid(const DepthSource& depth, int width, int height, int columns = 40, int rows = 30)
      : cell_(static_cast<double>(width) / columns, static_cast<double>(height) / rows),
        columns_(columns),
        rows_(rows) {
    static_assert(is_depth_source_v<DepthSource>,
                  "topobag: a depth source is callable as depth(Eigen::Vector2d pixel) -> "
                  "std::optional<double> metres.");
    if (width < 1 || height < 1 || columns < 1 || rows < 1) {
      throw InvalidValue("a depth grid needs an image and at least one cell");
    }
    require_registered(depth, width, height);
    cells_.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        cells_.push_back(least_depth(depth, Eigen::Vector2d(column, row)));
      }
    }
  }

  /// How far one can see at least in the cell of a pixel, m; nothing where that is not measured or
  /// outside the image. A depth source itself. O(1).
  std::optional<double> operator()(const Eigen::Vector2d& pixel) const noexcept {
    const Eigen::Vector2d place = (pixel.array() + 0.5) / cell_.array();
    // Written so that NaN fails as well.
    if (!(place.x() >= 0.0 && place.y() >= 0.0 && place.x() < columns_ && place.y() < rows_)) {
      return std::nullopt;
    }
    const auto column = static_cast<std::size_t>(place.x());
    const auto row = static_cast<std::size_t>(place.y());
    const float metres = cells_[row * static_cast<std::size_t>(columns_) + column];
    if (!(metres > 0.0F)) return std::nullopt;
    return static_cast<double>(metres);
  }

 private:
  static constexpr int samples = 4;  // a side

  template <typename DepthSource>
  float least_depth(const DepthSource& depth, const Eigen::Vector2d& cell) const {
    double least = std::numeric_limits<double>::infinity();
    int measured = 0;
    for (int i = 0; i < samples * samples; ++i) {
      const Eigen::Vector2d within((i % samples + 0.5) / samples, (i / samples + 0.5) / samples);
      const Eigen::Vector2d pixel = (cell + within).cwiseProduct(cell_).array() - 0.5;
      const std::optional<double> metres = depth(pixel);
      if (!metres || !(*metres > 0.0) || !std::isfinite(*metres)) continue;
      least = std::min(least, *metres);
      ++measured;
    }
    return 2 * measured < samples * samples ? 0.0F : static_cast<float>(least);
  }

  Eigen::Vector2d cell_;  // px
  int columns_;
  int rows_;
  std::vector<float> cells_;  // m, row by row; 0 = not measured
};

}  // namespace v0
}  // namespace topobag
