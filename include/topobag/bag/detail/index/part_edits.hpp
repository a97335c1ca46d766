// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <topobag/bag/camera_poses.hpp>
#include <topobag/bag/detail/index/bag_parts.hpp>
#include <topobag/bag/detail/index/dead_slots.hpp>
#include <topobag/bag/detail/index/head_block.hpp>
#include <topobag/bag/detail/index/part_builder.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// The same entries with an empty head.
template <typename Similarity>
BagParts sealed(BagParts parts, const Similarity& similarity) {
  auto segments = std::make_shared<BagParts::Sealed>(*parts.sealed);
  PartBuilder<Similarity> builder(similarity);
  for (std::size_t slot = 0; slot < parts.head_size; ++slot) {
    if (!parts.dead_in_head[slot]) builder.add(parts, {segments->size(), slot});
  }
  for (SealedPart& part : builder.finish()) segments->push_back(std::move(part));
  while (const std::size_t count = ripe_for_merge(*segments)) {
    SealedPart part = merged(*segments, count, similarity);
    segments->resize(segments->size() - count);
    segments->push_back(std::move(part));
  }
  BagParts next;
  next.sealed = std::move(segments);
  next.live = parts.live;
  next.kinds = parts.kinds;
  return next;
}

/// Adds an entry whose id is free. O(1) amortised, but for what `sealed` costs.
template <typename Similarity>
void append(BagParts& next, HeadBlock::Entry entry, const Similarity& similarity) {
  if (next.head_size == HeadBlock::capacity) next = sealed(std::move(next), similarity);
  if (!next.head) next.head = std::make_shared<HeadBlock>();
  (*next.head)[next.head_size++] = std::move(entry);
  ++next.live;
}

/// Takes an entry out. Its room comes back when half of its segment is gone.
template <typename Similarity>
void remove(BagParts& next, EntryPlace place, const Similarity& similarity) {
  --next.live;
  if (place.part == next.sealed->size()) {
    next.dead_in_head.set(place.slot);
    return;
  }
  auto parts = std::make_shared<BagParts::Sealed>(*next.sealed);
  SealedPart& part = (*parts)[place.part];
  auto dead = part.dead ? std::make_shared<DeadSlots>(*part.dead)
                        : std::make_shared<DeadSlots>(part.segment->size());
  dead->insert(place.slot);
  part.dead = std::move(dead);
  if (part.live() == 0) {
    parts->erase(parts->begin() + static_cast<std::ptrdiff_t>(place.part));
  } else if (2 * part.dead->size() > part.segment->size()) {
    part = merged<Similarity>({part}, 1, similarity);
  }
  next.sealed = std::move(parts);
}

/// The same entries at other poses. Graphs and index are shared with `parts`. Precondition: all are
/// there. O(entries of the segments that hold them).
inline BagParts with_poses(BagParts parts, const CameraPoses& poses) {
  std::vector<std::shared_ptr<SegmentInfos>> moved(parts.sealed->size());
  std::shared_ptr<HeadBlock> head;
  for (const auto& [id, T_world_camera] : poses) {
    const EntryPlace place = *parts.find(id);
    if (place.part == moved.size()) {
      if (!head) head = std::make_shared<HeadBlock>(*parts.head, parts.head_size);
      (*head)[place.slot].info.T_world_camera = T_world_camera;
      continue;
    }
    std::shared_ptr<SegmentInfos>& infos = moved[place.part];
    if (!infos) infos = std::make_shared<SegmentInfos>(*(*parts.sealed)[place.part].infos);
    infos->set_pose(place.slot, T_world_camera);
  }
  if (head) parts.head = std::move(head);
  auto segments = std::make_shared<BagParts::Sealed>(*parts.sealed);
  for (std::size_t part = 0; part < moved.size(); ++part) {
    if (!moved[part]) continue;
    moved[part]->renew_range((*segments)[part].segment->ids());
    (*segments)[part].infos = std::move(moved[part]);
  }
  parts.sealed = std::move(segments);
  return parts;
}

}  // namespace detail
}  // namespace v0
}  // namespace topobag
