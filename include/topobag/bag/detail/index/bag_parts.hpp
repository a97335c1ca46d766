// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <topobag/bag/detail/index/dead_slots.hpp>
#include <topobag/bag/detail/index/head_block.hpp>
#include <topobag/bag/detail/index/segment.hpp>
#include <topobag/bag/detail/index/segment_infos.hpp>
#include <topobag/bag/detail/storage/descriptor_kinds.hpp>
#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/place_contents.hpp>
#include <topobag/types/image_descriptor.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// A segment, what is known of its entries, and which of them are gone. All are shared between
/// views and never change.
struct SealedPart {
  std::shared_ptr<const Segment> segment;
  std::shared_ptr<const SegmentInfos> infos;
  std::shared_ptr<const DeadSlots> dead;  ///< none when all live

  bool is_live(std::size_t slot) const noexcept { return !dead || !dead->contains(slot); }
  std::size_t live() const noexcept { return segment->size() - (dead ? dead->size() : 0); }
};

/// Where an entry is: in a part, or, past the last part, in the head.
struct EntryPlace {
  std::size_t part = 0;
  std::size_t slot = 0;
};

/// An entry as the parts keep it.
struct StoredEntry {
  KeyframeId id{};
  const std::uint8_t* graph = nullptr;  ///< encoded, with `scan_margin` readable bytes behind it
  std::size_t graph_size = 0;
  float total = 0.0F;  ///< sum of the weights of its histogram
};

/// All entries of a bag at one moment. A copy is cheap: it shares what it holds.
struct BagParts {
  using Sealed = std::vector<SealedPart>;

  std::shared_ptr<const Sealed> sealed = std::make_shared<const Sealed>();  ///< oldest first
  std::shared_ptr<HeadBlock> head;  ///< newer than all of them; none when empty
  std::size_t head_size = 0;        ///< entries of it that belong here
  std::bitset<HeadBlock::capacity> dead_in_head;
  std::size_t live = 0;
  std::size_t places = 0;  ///< different ones among the live entries
  std::shared_ptr<const PlaceContents> contents = std::make_shared<const PlaceContents>();
  DescriptorKinds kinds;  ///< of all descriptors that were added

  /// O(segments · log n).
  std::optional<EntryPlace> find(KeyframeId id) const {
    for (std::size_t slot = head_size; slot-- > 0;) {
      if ((*head)[slot].id == id && !dead_in_head[slot]) return EntryPlace{sealed->size(), slot};
    }
    for (std::size_t part = sealed->size(); part-- > 0;) {
      if (!(*sealed)[part].infos->range().may_contain(id)) continue;
      const auto slot = (*sealed)[part].segment->slot_of(id);
      if (slot && (*sealed)[part].is_live(*slot)) return EntryPlace{part, *slot};
    }
    return std::nullopt;
  }

  /// The least id above this one, or the greatest below it; nothing at the end. O(segments · log n,
  /// and what is gone in between).
  std::optional<KeyframeId> next_id(KeyframeId id, bool above) const {
    std::optional<KeyframeId> next;
    const auto offer = [&](KeyframeId other) {
      if (above ? other <= id : other >= id) return;
      if (!next || (above ? other < *next : other > *next)) next = other;
    };
    for (const SealedPart& part : *sealed) {
      const Segment& segment = *part.segment;
      std::size_t rank = segment.rank(id);
      if (above) {
        if (rank < segment.size() && segment.id(segment.by_id(rank)) == id) ++rank;
        while (rank < segment.size() && !part.is_live(segment.by_id(rank))) ++rank;
        if (rank < segment.size()) offer(segment.id(segment.by_id(rank)));
      } else {
        while (rank > 0 && !part.is_live(segment.by_id(rank - 1))) --rank;
        if (rank > 0) offer(segment.id(segment.by_id(rank - 1)));
      }
    }
    for (std::size_t slot = 0; slot < head_size; ++slot) {
      if (!dead_in_head[slot]) offer((*head)[slot].id);
    }
    return next;
  }

  /// The ids of the entries whose cameras stand in the region, ascending.
  std::vector<KeyframeId> within(const MapRegion& region) const {
    std::vector<KeyframeId> found;
    for (const SealedPart& part : *sealed) {
      if (!part.infos->range().may_touch(region)) continue;
      for (std::size_t slot = 0; slot < part.segment->size(); ++slot) {
        if (part.infos->stands_in(slot, region) && part.is_live(slot)) {
          found.push_back(part.segment->id(slot));
        }
      }
    }
    for (std::size_t slot = 0; slot < head_size; ++slot) {
      const auto& T_world_camera = (*head)[slot].info.T_world_camera;
      if (dead_in_head[slot] || !T_world_camera) continue;
      if (region.contains(T_world_camera->translation())) found.push_back((*head)[slot].id);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  StoredEntry entry(EntryPlace place) const {
    if (place.part == sealed->size()) {
      const HeadBlock::Entry& entry = (*head)[place.slot];
      return {entry.id, entry.graph.data(), entry.graph.size() - scan_margin, entry.total};
    }
    const Segment& segment = *(*sealed)[place.part].segment;
    return {segment.id(place.slot), segment.graph(place.slot), segment.graph_size(place.slot),
            segment.total(place.slot)};
  }

  EntryInfo info(EntryPlace place) const {
    if (place.part == sealed->size()) return (*head)[place.slot].info;
    return (*(*sealed)[place.part].infos)[place.slot];
  }

  /// What the entry's image looks like; until the parts go.
  const ImageDescriptor& image(EntryPlace place) const {
    if (place.part == sealed->size()) return (*head)[place.slot].info.image;
    return (*sealed)[place.part].infos->image(place.slot);
  }

  /// Where every entry is. O(n log n).
  std::map<KeyframeId, EntryPlace> by_id() const {
    std::map<KeyframeId, EntryPlace> found;
    for_each([&](EntryPlace place) { found.emplace(entry(place).id, place); });
    return found;
  }

  /// Calls `visit(place)` for every entry, oldest first.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t part = 0; part < sealed->size(); ++part) {
      for (std::size_t slot = 0; slot < (*sealed)[part].segment->size(); ++slot) {
        if ((*sealed)[part].is_live(slot)) visit(EntryPlace{part, slot});
      }
    }
    for (std::size_t slot = 0; slot < head_size; ++slot) {
      if (!dead_in_head[slot]) visit(EntryPlace{sealed->size(), slot});
    }
  }
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
