// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include <topobag/bag/detail/codec/node_scan.hpp>
#include <topobag/bag/detail/index/bag_parts.hpp>
#include <topobag/bag/place_count.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The writer's count of places, and of what they hold a copy for readers, who keep it as long as
/// they like. A copy shares that.
class PublishedPlaces {
 public:
  void add(KeyframeId id, const EntryInfo& info, const ClassCounts& objects) {
    places_.add(id, info, objects);
  }
  void remove(KeyframeId id, const EntryInfo& info, const ClassCounts& objects) {
    places_.remove(id, info, objects);
  }
  /// An entry stands elsewhere now.
  /// @param before, after  with the entry at `place`, which is the same in both
  void move(const BagParts& before, const BagParts& after, EntryPlace place) {
    const auto [info, objects] = placed(before, place);
    const KeyframeId id = before.entry(place).id;
    places_.remove(id, info, objects);
    places_.add(id, after.info(place), objects);
  }
  void clear() noexcept { places_.clear(); }

  std::size_t size() const noexcept { return places_.size(); }

  /// What says in which place an entry is, and what it holds.
  std::pair<EntryInfo, ClassCounts> placed(const BagParts& parts, EntryPlace place) {
    return {parts.info(place), class_counts(scan_(parts.entry(place).graph))};
  }

  /// Counts those of all entries anew. O(n log places).
  void recount(const BagParts& parts) {
    places_.clear();
    parts.for_each([&](EntryPlace place) {
      const auto [info, objects] = placed(parts, place);
      places_.add(parts.entry(place).id, info, objects);
    });
  }

  /// What they hold now. O(1) when that has not changed, else O(class pairs).
  std::shared_ptr<const PlaceContents> contents() {
    const std::uint64_t revision = places_.contents().revision();
    if (published_ != revision) {
      contents_ = std::make_shared<const PlaceContents>(places_.contents());
      published_ = revision;
    }
    return contents_;
  }

 private:
  PlaceCount places_;
  NodeScan scan_;
  std::shared_ptr<const PlaceContents> contents_;
  std::optional<std::uint64_t> published_;  ///< revision that `contents_` is a copy of
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
