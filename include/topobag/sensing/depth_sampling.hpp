// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <topobag/assert.hpp>
#include <topobag/types/bounding_box.hpp>

namespace topobag {
inline namespace v0 {

/// A depth sampling policy is any callable `(depth source, box) -> std::optional<double>`, metres.
template <typename Sampling, typename Depth>
inline constexpr bool is_depth_sampling_v =
    std::is_invocable_r_v<std::optional<double>, const Sampling&, const Depth&, const BoundingBox&>;

/// The paper's sampling policy: the depth at the box centre (eq. 1). A hole there means no depth,
/// and what lies behind a chair's back rest passes for the chair.
struct CenterDepth {
  template <typename Depth>
  std::optional<double> operator()(const Depth& depth, const BoundingBox& box) const {
    return depth(box.center());
  }
};

namespace detail {

/// The median of the nearest dense cluster of ascending depths, m; see `RobustBoxDepth`.
/// Precondition: there is one at least. O(n).
inline double nearest_cluster(const std::vector<double>& depths, double cluster_width,
                              double min_cluster_share) {
  // A window slides over the sorted depths; its count is the density there.
  const std::size_t n = depths.size();
  std::vector<std::size_t> window_end(n);
  std::size_t largest = 0;
  for (std::size_t begin = 0, end = 0; begin < n; ++begin) {
    const double limit = depths[begin] + std::max(0.05, cluster_width * depths[begin]);
    while (end < n && depths[end] <= limit) ++end;
    window_end[begin] = end;
    largest = std::max(largest, end - begin);
  }
  const double enough = std::min(min_cluster_share, 1.0) * static_cast<double>(largest);
  std::size_t first = 0;
  while (static_cast<double>(window_end[first] - first) < enough) ++first;
  // The first window that is dense enough may only touch its cluster: go on to the fullest one
  // near by.
  std::size_t best = first;
  for (std::size_t i = first; i < window_end[first]; ++i) {
    if (window_end[i] - i > window_end[best] - best) best = i;
  }
  return depths[best + (window_end[best] - best) / 2];
}

}  // namespace detail

/// The median of the nearest dense cluster of depths in the middle of the box.
///
/// Holes are left out; edges and the background behind an object form clusters of their own.
/// Deterministic. O(s² log s) for an s × s grid.
struct RobustBoxDepth {
  double central_share = 0.6;    ///< share of the box's width and height that is sampled
  int grid = 24;                 ///< at most grid × grid samples; >= 1
  double min_valid_share = 0.1;  ///< with fewer measured samples there is no depth
  double cluster_width = 0.06;   ///< a cluster spans this share of its depth, and at least 5 cm
  double min_cluster_share =
      0.5;  ///< nearest cluster with this share (0 to 1) of the largest one's samples wins

  template <typename Depth>
  std::optional<double> operator()(const Depth& depth, const BoundingBox& box) const {
    const std::vector<double> depths = samples(depth, box);
    if (depths.empty()) return std::nullopt;

    return detail::nearest_cluster(depths, cluster_width, min_cluster_share);
  }

 private:
  /// The measured depths on the grid, ascending; empty when too few are measured.
  template <typename Depth>
  std::vector<double> samples(const Depth& depth, const BoundingBox& box) const {
    const double width = box.width() * central_share;
    const double height = box.height() * central_share;
    const int columns = grid_size(width);
    const int rows = grid_size(height);
    const Eigen::Vector2d corner = box.center() - Eigen::Vector2d(width, height) / 2.0;
    std::vector<double> depths;
    depths.reserve(static_cast<std::size_t>(columns * rows));
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const Eigen::Vector2d pixel =
            corner + Eigen::Vector2d((column + 0.5) * width / columns, (row + 0.5) * height / rows);
        const std::optional<double> z = depth(pixel);
        if (z && *z > 0.0 && std::isfinite(*z)) depths.push_back(*z);
      }
    }
    if (static_cast<double>(depths.size()) < min_valid_share * columns * rows) depths.clear();
    std::sort(depths.begin(), depths.end());
    return depths;
  }

  /// One sample a pixel, at most `grid`; clamped as a double, for a box may be wider than an int.
  int grid_size(double pixels) const {
    TOPOBAG_ASSERT(grid >= 1);
    return static_cast<int>(std::clamp(pixels, 1.0, static_cast<double>(grid)));
  }
};

}  // namespace v0
}  // namespace topobag
