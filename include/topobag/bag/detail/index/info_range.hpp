// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include <Eigen/Geometry>

#include <topobag/bag/entry_filter.hpp>
#include <topobag/bag/entry_info.hpp>
#include <topobag/types/ids.hpp>

namespace topobag {
inline namespace v0 {
namespace detail {

/// What the ids and the infos of some entries lie between, to rule all of them out at once.
class InfoRange {
 public:
  void extend(KeyframeId id, const EntryInfo& info) {
    least_id_ = std::min(least_id_, id);
    greatest_id_ = std::max(greatest_id_, id);
    least_session_ = std::min(least_session_, info.session);
    greatest_session_ = std::max(greatest_session_, info.session);
    if (info.stamp) {
      least_stamp_ = std::min(least_stamp_, *info.stamp);
      greatest_stamp_ = std::max(greatest_stamp_, *info.stamp);
    }
    if (info.T_world_camera) cameras_.extend(info.T_world_camera->translation());
  }

  bool may_contain(KeyframeId id) const noexcept { return id >= least_id_ && id <= greatest_id_; }

  /// False when the filter passes none of the entries for certain.
  bool may_pass(const EntryFilter& filter) const {
    if (filter.min_id > greatest_id_ || filter.max_id < least_id_) return false;
    if (filter.min_stamp && *filter.min_stamp > greatest_stamp_) return false;
    if (filter.max_stamp && *filter.max_stamp < least_stamp_) return false;
    const auto& sessions = filter.sessions;
    const auto has = [this](std::uint32_t session) {
      return session >= least_session_ && session <= greatest_session_;
    };
    if (!sessions.empty() && std::none_of(sessions.begin(), sessions.end(), has)) return false;
    if (filter.not_of && all_in(*filter.not_of)) return false;
    return !filter.region || may_touch(*filter.region);
  }

  /// False when no camera stands in the region for certain.
  bool may_touch(const MapRegion& region) const {
    if (cameras_.isEmpty()) return false;
    const Eigen::Vector3d nearest = region.center.cwiseMax(cameras_.min()).cwiseMin(cameras_.max());
    return region.contains(nearest);
  }

 private:
  /// Whether all entries belong to the visit.
  bool all_in(const PresentVisit& visit) const {
    return least_session_ == visit.session && greatest_session_ == visit.session &&
           least_stamp_ > visit.since;
  }

  KeyframeId least_id_{std::numeric_limits<std::uint64_t>::max()}, greatest_id_{0};
  std::uint32_t least_session_ = std::numeric_limits<std::uint32_t>::max(), greatest_session_ = 0;
  // Of the entries that have one:
  double least_stamp_ = std::numeric_limits<double>::infinity();  ///< s
  double greatest_stamp_ = -std::numeric_limits<double>::infinity();
  Eigen::AlignedBox3d cameras_;  ///< m, world
};

}  // namespace detail
}  // namespace v0
}  // namespace topobag
