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
/// Places are the cells of a grid of `cell` m that hold a camera. Key frames without a pose count by
/// their ids: those of one session in one run of `ids_per_place` are one place, if stamps say that
/// they follow each other; of one without either, nothing tells what it is near, and it is a place.
/// The count depends on what is in the map alone, not on the order in which it came.
class PlaceCount {
 public:
  static constexpr double cell = 3.0;                 ///< m, about as far as a view has objects
  static constexpr std::uint64_t ids_per_place = 30;  ///< key frames

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
  using Key = std::tuple<bool, std::int64_t, std::int64_t, std::int64_t>;
  struct Place {
    std::size_t entries = 0;
    std::map<ClassId, std::map<std::size_t, std::size_t>> counts;  ///< entries that hold so many

    std::size_t most(ClassId label) const {
      const auto of_label = counts.find(label);
      return of_label == counts.end() ? 0 : of_label->second.rbegin()->first;
    }
  };

  static Key key_of(KeyframeId id, const EntryInfo& info) {
    if (!info.T_world_camera) {
      const std::uint64_t run = info.stamp ? ids_per_place : 1;
      return {false, info.session, static_cast<std::int64_t>(value(id) / run), info.stamp ? 1 : 0};
    }
    const auto at = info.T_world_camera->translation();
    const auto cell_of = [](double metres) {
      const double limit = 9e18;  // beyond any pose, within 64 bits
      return static_cast<std::int64_t>(
          std::floor(std::fmax(-limit, std::fmin(limit, metres / cell))));
    };
    return {true, cell_of(at.x()), cell_of(at.y()), cell_of(at.z())};
  }

  std::map<Key, Place> places_;
  PlaceContents contents_;
};

}  // namespace v0
}  // namespace topobag
