// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <topobag/bag/detail/index/bag_parts.hpp>
#include <topobag/bag/detail/index/encoded_entry.hpp>
#include <topobag/graph/detail/rescaled.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// So many graphs make a segment at most: a merge, which the writer waits for, takes some 50 ms.
inline constexpr std::size_t max_segment_size = LeafBounds::max_leaves;
/// So many segments of about one size become one.
inline constexpr std::size_t merge_fan_in = 4;

/// What a builder has put together, all of it live.
template <typename Similarity>
SealedPart finished(Segment::Builder<Similarity>& builder) {
  return {std::make_shared<const Segment>(builder.build()),
          std::make_shared<const SegmentInfos>(builder.take_infos()), nullptr};
}

/// Makes segments of entries that come one by one.
template <typename Similarity>
class PartBuilder {
 public:
  explicit PartBuilder(const Similarity& similarity)
      : similarity_(similarity), segment_(similarity) {}

  void add(KeyframeId id, const EntryInfo& info, const std::uint8_t* graph, std::size_t size) {
    if (segment_.size() == max_segment_size ||
        segment_.graph_bytes() + size + scan_margin > Segment::max_bytes) {
      end_segment();
    }
    segment_.add(id, info, graph, size);
  }

  /// Another bag's entry, with what this one keeps of its graph, in this one's unit.
  /// @param scale  of that in one of the other's
  void add(KeyframeId id, const EntryInfo& info, const StoredEntry& entry, ViewSection views,
           double scale) {
    if (views == ViewSection::kept && scale == 1.0) {
      add(id, info, entry.graph, entry.graph_size);
    } else {
      const auto own = decode(entry.graph, entry.graph_size);
      const auto graph = stored_bytes(*Rescaled<TopologyGraph<double>>(own, scale), views);
      add(id, info, graph.data(), graph.size() - scan_margin);
    }
  }

  void add(const BagParts& parts, EntryPlace place) {
    const StoredEntry entry = parts.entry(place);
    add(entry.id, parts.info(place), entry.graph, entry.graph_size);
  }

  std::vector<SealedPart> finish() {
    end_segment();
    return std::move(parts_);
  }

 private:
  void end_segment() {
    if (segment_.size() == 0) return;
    parts_.push_back(finished(segment_));
    segment_ = Segment::Builder<Similarity>(similarity_);
  }

  const Similarity& similarity_;
  Segment::Builder<Similarity> segment_;
  std::vector<SealedPart> parts_;
};

/// How many segments at the end are to become one: at least `merge_fan_in` none of which is more
/// than so many times as large as the last; or 0.
inline std::size_t ripe_for_merge(const std::vector<SealedPart>& parts) {
  if (parts.empty()) return 0;
  std::size_t count = 0, entries = 0, bytes = 0;
  const std::size_t limit = merge_fan_in * parts.back().segment->size();
  for (auto part = parts.rbegin(); part != parts.rend(); ++part, ++count) {
    entries += part->segment->size();
    bytes += part->segment->graph_bytes();
    if (part->segment->size() >= limit || entries > max_segment_size ||
        bytes + scan_margin > Segment::max_bytes) {
      break;
    }
  }
  return count >= merge_fan_in ? count : 0;
}

/// One segment of the last `count`. Keeps their leaves; where entries are gone, makes new ones.
template <typename Similarity>
SealedPart merged(const std::vector<SealedPart>& parts, std::size_t count,
                  const Similarity& similarity) {
  Segment::Builder<Similarity> builder(similarity);
  for (std::size_t i = parts.size() - count; i < parts.size(); ++i) {
    const Segment& segment = *parts[i].segment;
    if (!parts[i].dead) {
      builder.add(segment, *parts[i].infos);
      continue;
    }
    for (std::size_t slot = 0; slot < segment.size(); ++slot) {
      if (!parts[i].is_live(slot)) continue;
      builder.add(segment.id(slot), (*parts[i].infos)[slot], segment.graph(slot),
                  segment.graph_size(slot));
    }
  }
  return finished(builder);
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
