// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <Eigen/Core>

#include <topobag/error.hpp>
#include <topobag/sensing/depth_view.hpp>

namespace topobag {
inline namespace v0 {

/// A coarse copy of a depth image that keeps, for each cell, how far one can see at least: what a
/// key frame's free space costs to remember, 60 bytes in a map. It is as coarse in memory as in a
/// file, so that a map says the same after it is loaded.
class DepthGrid {
 public:
  static constexpr int columns = 10;  ///< cells in a row
  static constexpr int rows = 8;      ///< of cells
  /// A cell's depth by its octave, rounded down; 0 = not measured.
  using Level = std::uint8_t;
  static constexpr unsigned level_bits = 6;       ///< of a level
  static constexpr double least_metres = 0.25;    ///< of level 1; what is nearer is not measured
  static constexpr double levels_per_octave = 8;  ///< up to 54 m; what is further counts as that
  using Levels = std::array<Level, static_cast<std::size_t>(columns* rows)>;  ///< row by row

  /// @param depth         the depth source of an image
  /// @param width,height  of the image, px
  /// Each cell takes the least of 8 × 8 depths spread over it, and none when fewer than half of
  /// them are measured. Throws InvalidValue for a size below 1, and as `require_registered`.
  /// O(cells · 64).
  template <typename DepthSource>
  DepthGrid(const DepthSource& depth, int width, int height) : width_(width), height_(height) {
    static_assert(is_depth_source_v<DepthSource>,
                  "topobag: a depth source is callable as depth(Eigen::Vector2d pixel) -> "
                  "std::optional<double> metres.");
    require_size();
    require_registered(depth, width, height);
    for (std::size_t cell = 0; cell < levels_.size(); ++cell) {
      const auto column = static_cast<double>(cell % columns);
      const auto row = static_cast<double>(cell / columns);
      levels_[cell] = level_of(least_depth(depth, {column, row}));
    }
  }

  /// As `levels()` kept it. Throws InvalidValue for an image's size below 1.
  DepthGrid(const Levels& levels, int width, int height)
      : width_(width), height_(height), levels_(levels) {
    require_size();
  }

  /// Of the image, px.
  int width() const noexcept { return width_; }
  /// Of the image, px.
  int height() const noexcept { return height_; }
  /// All that is kept of the depths.
  const Levels& levels() const noexcept { return levels_; }

  /// The same in another unit of length: all depths times `factor`, to the eighth of an octave
  /// below. Throws InvalidValue for a factor that is not positive and finite.
  DepthGrid scaled(double factor) const {
    if (!(factor > 0.0 && std::isfinite(factor))) {
      throw InvalidValue("depths are scaled by a positive number");
    }
    const double levels = std::floor(levels_per_octave * std::log2(factor));
    const double most = (1 << level_bits) - 1;
    DepthGrid result = *this;
    for (Level& level : result.levels_) {
      if (level > 0) level = static_cast<Level>(std::clamp(level + levels, 0.0, most));
    }
    return result;
  }

  /// How far one can see at least in the cell of a pixel, m, to the eighth of an octave below;
  /// nothing where that is not measured or outside the image. A depth source itself. O(1).
  std::optional<double> operator()(const Eigen::Vector2d& pixel) const noexcept {
    const Eigen::Vector2d place = (pixel.array() + 0.5) / cell_size().array();
    // Written so that NaN fails as well.
    if (!(place.x() >= 0.0 && place.y() >= 0.0 && place.x() < columns && place.y() < rows)) {
      return std::nullopt;
    }
    const auto cell =
        static_cast<std::size_t>(place.y()) * columns + static_cast<std::size_t>(place.x());
    if (levels_[cell] == 0) return std::nullopt;
    return least_metres * std::exp2((levels_[cell] - 1.0) / levels_per_octave);
  }

 private:
  static constexpr int samples = 8;  // a side

  void require_size() const {
    if (width_ < 1 || height_ < 1) throw InvalidValue("a depth grid needs an image");
  }

  Eigen::Vector2d cell_size() const noexcept {  // px
    return {static_cast<double>(width_) / columns, static_cast<double>(height_) / rows};
  }

  /// Of the cell at that column and row, m; 0 = not measured.
  template <typename DepthSource>
  double least_depth(const DepthSource& depth, const Eigen::Vector2d& cell) const {
    double least = std::numeric_limits<double>::infinity();
    int measured = 0;
    for (int i = 0; i < samples * samples; ++i) {
      const Eigen::Vector2d within((i % samples + 0.5) / samples, (i / samples + 0.5) / samples);
      const Eigen::Vector2d pixel = (cell + within).cwiseProduct(cell_size()).array() - 0.5;
      const std::optional<double> metres = depth(pixel);
      if (!metres || !(*metres > 0.0) || !std::isfinite(*metres)) continue;
      least = std::min(least, *metres);
      ++measured;
    }
    return 2 * measured < samples * samples ? 0.0 : least;
  }

  static Level level_of(double metres) {
    if (!(metres >= least_metres)) return 0;
    const double octaves = std::log2(metres / least_metres);
    const double most = (1 << level_bits) - 1;
    return static_cast<Level>(std::min(most, 1.0 + std::floor(levels_per_octave * octaves)));
  }

  int width_;
  int height_;
  Levels levels_{};
};

}  // namespace v0
}  // namespace topobag
