// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

#include <topobag/bag/entry_info.hpp>
#include <topobag/bag/place_contents.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {

/// How many different places a map holds: key frames of one spot are one place, however many they
/// are. A query asks them all, so that its chance of a false match grows with them; more exactly,
/// with those that hold objects like the matched ones, for no other could have given the match.
///
/// Places are the cells of a grid of `cell` m that hold a camera. Key frames without a pose count
/// by their stamps: those of one session within one run of `seconds_per_place` are one place; of
/// one without either, nothing tells what it is near, and it is a place. The count depends on what
/// is in the map alone, not on the order in which it came.
class PlaceCount {
 public:
  static constexpr double cell = 3.0;                ///< m, about as far as a view has objects
  static constexpr double seconds_per_place = 12.0;  ///< in which a robot passes some such cells

  /// Counts an entry. O(log places + classes²).
  /// @param objects  that its graph holds; a place holds as many of a class as the richest of them
  void add(KeyframeId id, const EntryInfo& info, const ClassCounts& objects = {}) {
    Place& place = places_[key_of(id, info)];
    ++place.entries;
    for (const auto& [label, count] : objects) {
      for (std::size_t n = place.most(label) + 1; n <= count; ++n) contents_.add(label, n);
      if (place.most(label) == 0) {
        for (const auto& [other, counts] : place.counts) contents_.add(label, other);
      }
      ++place.counts[label][count];
    }
  }

  /// Takes it out again. Precondition: it was added with the same arguments. O(log places +
  /// classes²).
  void remove(KeyframeId id, const EntryInfo& info, const ClassCounts& objects = {}) {
    const auto at = places_.find(key_of(id, info));
    Place& place = at->second;
    for (const auto& [label, count] : objects) {
      auto& counts = place.counts[label];
      if (--counts[count] == 0) counts.erase(count);
      if (counts.empty()) {
        place.counts.erase(label);
        for (const auto& [other, of_other] : place.counts) contents_.remove(label, other);
      }
      for (std::size_t n = place.most(label) + 1; n <= count; ++n) contents_.remove(label, n);
    }
    if (--place.entries == 0) places_.erase(at);
  }

  void clear() noexcept {
    places_.clear();
    contents_.clear();
  }

  /// Places with an entry.
  std::size_t size() const noexcept { return places_.size(); }

  /// What they hold.
  const PlaceContents& contents() const noexcept { return contents_; }

 private:
  /// What tells a place from others.
  enum class Kind { alone, passed, seen };  // by its id, by session and stamp, by its cell
  using Key = std::tuple<Kind, std::int64_t, std::int64_t, std::int64_t>;
  struct Place {
    std::size_t entries = 0;
    std::map<ClassId, std::map<std::size_t, std::size_t>> counts;  ///< entries that hold so many

    std::size_t most(ClassId label) const {
      const auto of_label = counts.find(label);
      return of_label == counts.end() ? 0 : of_label->second.rbegin()->first;
    }
  };

  static Key key_of(KeyframeId id, const EntryInfo& info) {
    if (!info.T_world_camera && !info.stamp) {
      return {Kind::alone, static_cast<std::int64_t>(value(id)), info.session, 0};
    }
    if (!info.T_world_camera) {
      return {Kind::passed, cell_of(*info.stamp, seconds_per_place), info.session, 0};
    }
    const auto at = info.T_world_camera->translation();
    return {Kind::seen, cell_of(at.x(), cell), cell_of(at.y(), cell), cell_of(at.z(), cell)};
  }

  static std::int64_t cell_of(double at, double side) {
    const double limit = 9e18;  // beyond any pose or stamp, within 64 bits
    return static_cast<std::int64_t>(std::floor(std::fmax(-limit, std::fmin(limit, at / side))));
  }

  std::map<Key, Place> places_;
  PlaceContents contents_;
};

}  // namespace v0
}  // namespace topobag
