// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include <topobag/bag/detail/index/info_columns.hpp>
#include <topobag/bag/detail/index/info_range.hpp>
#include <topobag/bag/entry_filter.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// What is known of a segment's entries beside their graphs, by slot. Apart from the segment: when
/// poses change, graphs and index stay where they are.
class SegmentInfos {
 public:
  void push_back(KeyframeId id, const EntryInfo& info) {
    columns_.push_back(info);
    range_.extend(id, info);
  }

  EntryInfo operator[](std::size_t slot) const { return columns_[slot]; }
  const ImageDescriptor& image(std::size_t slot) const { return columns_.image(slot); }
  /// Whether the entry has a pose, and its camera stands in the region.
  bool stands_in(std::size_t slot, const MapRegion& region) const {
    return columns_.stands_in(slot, region);
  }
  const InfoRange& range() const noexcept { return range_; }  ///< of all ids and infos
  std::size_t bytes() const noexcept { return columns_.bytes() + sizeof(*this); }
  void shrink_to_fit() { columns_.shrink_to_fit(); }

  /// The range is that of before until `renew_range`.
  void set_pose(std::size_t slot, const Eigen::Isometry3d& T_world_camera) {
    columns_.set_pose(slot, T_world_camera);
  }
  /// @param ids  of the slots
  void renew_range(const std::vector<KeyframeId>& ids) {
    range_ = {};
    for (std::size_t slot = 0; slot < ids.size(); ++slot) range_.extend(ids[slot], columns_[slot]);
  }

 private:
  InfoColumns columns_;
  InfoRange range_;
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
