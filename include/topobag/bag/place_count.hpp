// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

#include <topobag/bag/entry_info.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// How many different places a map holds: key frames of one spot are one place, however many they
/// are. A look-up asks them all, so that its chance of a false match grows with them.
///
/// Places are the cells of a grid of `cell` m that hold a camera. Key frames without a pose, of
/// which nothing tells how far apart they are, count by their ids: those of one session in one run
/// of `ids_per_place` are one place. The count depends on what is in the map alone, not on the
/// order in which it came.
class PlaceCount {
 public:
  static constexpr double cell = 3.0;                 ///< m, about as far as a view has objects
  static constexpr std::uint64_t ids_per_place = 30;  ///< key frames

  /// Counts an entry. O(log places).
  void add(KeyframeId id, const EntryInfo& info) { ++entries_[place_of(id, info)]; }

  /// Takes it out again. Precondition: it was added with the same id and info. O(log places).
  void remove(KeyframeId id, const EntryInfo& info) {
    const auto place = entries_.find(place_of(id, info));
    if (--place->second == 0) entries_.erase(place);
  }

  void clear() noexcept { entries_.clear(); }

  /// Places with an entry.
  std::size_t size() const noexcept { return entries_.size(); }

 private:
  using Place = std::tuple<bool, std::int64_t, std::int64_t, std::int64_t>;

  static Place place_of(KeyframeId id, const EntryInfo& info) {
    if (!info.T_world_camera) {
      return {false, info.session, static_cast<std::int64_t>(value(id) / ids_per_place), 0};
    }
    const auto at = info.T_world_camera->translation();
    const auto cell_of = [](double metres) {
      const double limit = 9e18;  // beyond any pose, within 64 bits
      return static_cast<std::int64_t>(
          std::floor(std::fmax(-limit, std::fmin(limit, metres / cell))));
    };
    return {true, cell_of(at.x()), cell_of(at.y()), cell_of(at.z())};
  }

  std::map<Place, std::size_t> entries_;
};

}  // namespace v0
}  // namespace topobag
