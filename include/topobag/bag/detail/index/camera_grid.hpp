// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include <Eigen/Core>

#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/place_count.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// Where in the world the cameras of a bag's entries stand: those of a region are found without
/// looking at the others. Entries without a pose are nowhere.
class CameraGrid {
 public:
  /// O(log cells).
  void add(KeyframeId id, const EntryInfo& info) {
    if (!info.T_world_camera) return;
    const Eigen::Vector3d at = info.T_world_camera->translation();
    cells_[cell_of(at)].push_back({id, at});
  }

  /// Precondition: it was added with the same id and info. O(log cells + entries of the cell).
  void remove(KeyframeId id, const EntryInfo& info) {
    if (!info.T_world_camera) return;
    const auto cell = cells_.find(cell_of(info.T_world_camera->translation()));
    std::vector<Camera>& cameras = cell->second;
    const auto camera = std::find_if(cameras.begin(), cameras.end(),
                                     [&](const Camera& other) { return other.id == id; });
    *camera = cameras.back();
    cameras.pop_back();
    if (cameras.empty()) cells_.erase(cell);
  }

  void clear() noexcept { cells_.clear(); }

  /// Those in the region, ascending. O(rows of cells that it meets · log cells + their cameras).
  std::vector<KeyframeId> within(const MapRegion& region) const {
    const Cell low = cell_of(region.center - Eigen::Vector3d::Constant(region.radius));
    const Cell high = cell_of(region.center + Eigen::Vector3d::Constant(region.radius));
    std::vector<KeyframeId> found;
    // Over what lies beside the region at once: never more steps than filled cells, however large.
    for (auto cell = cells_.lower_bound(low); cell != cells_.end() && cell->first[0] <= high[0];) {
      const Cell& at = cell->first;
      std::size_t axis = 0;
      while (axis < 3 && at[axis] >= low[axis] && at[axis] <= high[axis]) ++axis;
      if (axis == 3) {
        for (const Camera& camera : cell->second) {
          if (region.contains(camera.position)) found.push_back(camera.id);
        }
        ++cell;
        continue;
      }
      Cell next = at;
      if (at[axis] > high[axis]) ++next[axis - 1];  // axis > 0: the loop ends beyond the first
      for (std::size_t i = axis; i < 3; ++i) next[i] = low[i];
      cell = cells_.lower_bound(next);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  static constexpr double side = PlaceCount::cell;  // m

  using Cell = std::array<std::int64_t, 3>;
  struct Camera {
    KeyframeId id;
    Eigen::Vector3d position;
  };

  static Cell cell_of(const Eigen::Vector3d& at) {
    const auto number = [](double metres) {
      const double limit = 9e18;  // beyond any pose, within 64 bits
      return static_cast<std::int64_t>(
          std::floor(std::fmax(-limit, std::fmin(limit, metres / side))));
    };
    return {number(at.x()), number(at.y()), number(at.z())};
  }

  std::map<Cell, std::vector<Camera>> cells_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
